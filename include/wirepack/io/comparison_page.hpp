#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/packing/comparison.hpp"

namespace wirepack {

/// What a comparison says, a sentence each: a verdict for every quantity, where the force goes with
/// friction, what friction does to the order of the coils, what both methods cost.
std::vector<std::string> findings(const Comparison& comparison);

/// The numbers as text: a block to each quantity, a line to each way, a column to each density.
std::string comparison_table(const Comparison& comparison);

/// The same as JSON.
std::string comparison_json(const Comparison& comparison);

/// What write_comparison() puts in its folder.
std::vector<std::string> comparison_files();

/// The page of a run, to which a comparison leads.
struct RunPage {
  std::string label, file;  ///< `file` lies in the folder of the comparison
};

/// What a comparison's page says beside its numbers.
struct ComparisonText {
  std::string title, config;
  std::vector<RunPage> pages;
};

/// Draws every quantity against the density (NAME.png, .pdf, .svg, .dat, .gp) and writes
/// comparison.json and comparison.html, one page that needs no other file. Throws FileError.
void write_comparison(const std::filesystem::path& folder, const ComparisonText& text,
                      const std::vector<ComparedRun>& runs, const Comparison& comparison);

}  // namespace wirepack
