#include <cmath>
#include <iostream>

#include <wirepack/rod/rod_params.hpp>

int main() {
  const double bend = wirepack::stiffness(wirepack::RodParams{}).bend;
  std::cout << "bending stiffness of the default wire: " << bend << '\n';
  // Y pi a^4 / 4 with Y = 5 and a = 1, known here to six digits.
  return std::abs(bend - 3.92699) < 1e-5 ? 0 : 1;
}
