#include "alexander.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace wirepack {

namespace {

using Row = std::map<std::uint32_t, std::uint64_t>;

/// Where an edge passes another in the picture.
struct Passage {
  double place;  // edge number, and the part of the edge that lies before
  std::size_t crossing;
  bool below;
};

struct Meeting {
  double at_first, at_second;
  bool first_below;
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool meet(const Points& p, Index i, Index j, Meeting& meeting) {
  const Index n = p.cols();
  const Vec3 a = p.col(i), b = p.col(j), e = p.col((i + 1) % n) - a, f = p.col((j + 1) % n) - b;
  const double area = cross(e.head<2>(), f.head<2>());
  const Eigen::Vector2d between = (b - a).head<2>();
  const double s = cross(between, f.head<2>()) / area, t = cross(between, e.head<2>()) / area;
  if (!(s >= 0 && s < 1 && t >= 0 && t < 1)) return false;
  const double height = (a + s * e).z() - (b + t * f).z();
  meeting = {static_cast<double>(i) + s, static_cast<double>(j) + t, height < 0};
  return true;
}

bool is_right_handed(const Points& p, Index over, Index under) {
  const auto edge = [&](Index i) -> Vec3 { return p.col((i + 1) % p.cols()) - p.col(i); };
  return cross(edge(over).head<2>(), edge(under).head<2>()) > 0;
}

std::vector<Row> alexander_rows(const std::vector<Crossing>& diagram, std::uint64_t t) {
  const auto last = static_cast<std::uint32_t>(diagram.size() - 1);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < last; ++k) {
    const Crossing& c = diagram[k];
    Row row;
    const auto add = [&](std::uint32_t arc, std::uint64_t value) {
      if (arc != last) row[arc] = (row[arc] + value) % prime;
    };
    add(c.over, (1 + prime - t) % prime);
    add(c.incoming, c.right_handed ? t : prime - 1);
    add(c.outgoing, c.right_handed ? prime - 1 : t);
    std::erase_if(row, [](const auto& entry) { return entry.second == 0; });
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Sparse elimination: the shortest row goes next, by its rarest column (Markowitz 1957).
class Elimination {
 public:
  explicit Elimination(std::vector<Row> rows) : rows_(std::move(rows)), with_(rows_.size()) {
    for (std::uint32_t k = 0; k < rows_.size(); ++k) {
      waiting_.emplace(rows_[k].size(), k);
      for (const auto& [column, value] : rows_[k]) with_[column].insert(k);
    }
  }

  std::uint64_t determinant() {
    std::uint64_t product = 1;
    while (!waiting_.empty()) {
      const std::uint32_t pivot = waiting_.begin()->second;
      if (rows_[pivot].empty()) return 0;
      waiting_.erase(waiting_.begin());
      const auto rarest = std::min_element(rows_[pivot].begin(), rows_[pivot].end(),
                                           [&](const auto& a, const auto& b) {
                                             return with_[a.first].size() < with_[b.first].size();
                                           });
      product = product * rarest->second % prime;
      for (const auto& [column, value] : rows_[pivot]) with_[column].erase(pivot);
      eliminate(pivot, rarest->first, inverse(rarest->second));
    }
    return std::min(product, prime - product);
  }

 private:
  void eliminate(std::uint32_t pivot, std::uint32_t column, std::uint64_t inverse_value) {
    const std::vector<std::uint32_t> others(with_[column].begin(), with_[column].end());
    for (const std::uint32_t other : others) {
      Row& row = rows_[other];
      waiting_.erase({row.size(), other});
      const std::uint64_t factor = prime - row[column] * inverse_value % prime;
      for (const auto& [k, value] : rows_[pivot]) {
        const auto place = row.try_emplace(k, 0).first;
        place->second = (place->second + factor * value) % prime;
        if (place->second == 0) {
          row.erase(place);
          with_[k].erase(other);
        } else {
          with_[k].insert(other);
        }
      }
      waiting_.emplace(row.size(), other);
    }
  }

  std::vector<Row> rows_;
  std::vector<std::set<std::uint32_t>> with_;                // rows that have a column
  std::set<std::pair<std::size_t, std::uint32_t>> waiting_;  // by length
};

}  // namespace

std::uint64_t inverse(std::uint64_t value) {
  std::uint64_t result = 1;  // value^(prime - 2), Fermat
  for (std::uint64_t power = prime - 2; power > 0; power /= 2) {
    if (power % 2 == 1) result = result * value % prime;
    value = value * value % prime;
  }
  return result;
}

std::vector<Crossing> knot_diagram(const Points& polygon) {
  const Index n = polygon.cols();
  std::vector<Passage> passages;
  std::vector<Crossing> crossings;
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 2; j < n; ++j) {
      Meeting m;
      if ((i == 0 && j == n - 1) || !meet(polygon, i, j, m)) continue;
      passages.push_back({m.at_first, crossings.size(), m.first_below});
      passages.push_back({m.at_second, crossings.size(), !m.first_below});
      const bool right =
          m.first_below ? is_right_handed(polygon, j, i) : is_right_handed(polygon, i, j);
      crossings.push_back({0, 0, 0, right});
    }
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passage& a, const Passage& b) { return a.place < b.place; });
  const auto count = static_cast<std::uint32_t>(crossings.size());
  std::uint32_t arc = 0;
  for (const Passage& passage : passages) {
    Crossing& crossing = crossings[passage.crossing];
    if (!passage.below) {
      crossing.over = arc;
      continue;
    }
    crossing.incoming = arc;
    arc = (arc + 1) % count;
    crossing.outgoing = arc;
  }
  return crossings;
}

std::uint64_t alexander_polynomial(const std::vector<Crossing>& diagram, std::uint64_t t) {
  if (diagram.size() < 2) return 1;
  return Elimination(alexander_rows(diagram, t)).determinant();
}

}  // namespace wirepack
