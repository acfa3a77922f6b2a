#pragma once

#include <string_view>

namespace wirepack {

/// Where a build comes from; every result file keeps it.
struct Version {
  std::string_view program;     ///< "0.1.0"
  std::string_view git_commit;  ///< of the checkout that was built, "-dirty" with local changes;
                                ///< "unknown" outside of a checkout
  std::string_view compiler;    ///< "GNU 12.2.0, Release, tuned for the machine"
  std::string_view libraries;   ///< "Eigen 3.4.0, NLopt 2.7.1, ..."
};

Version version();

}  // namespace wirepack
