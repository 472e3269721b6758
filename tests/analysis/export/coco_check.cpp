#include "tests/analysis/export/coco_check.h"

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using Complaints = std::vector<std::string>;

std::string header(const std::string& fopt, int dimension) {
  std::string text = "% f evaluations | g evaluations | best noise-free fitness - Fopt (" + fopt +
                     ") + sum g_i+ | measured fitness | best measured fitness or single-digit "
                     "g-values";
  for (int k = 1; k <= dimension; ++k) text += " | x" + std::to_string(k);
  return text;
}

struct Block {
  double fopt;
  std::vector<CocoRow> rows;
};

void check_rows(const Block& block, Complaints& complaints) {
  if (block.rows.empty()) return complaints.push_back("a run without rows");
  if (block.rows[0].evaluations != 1) complaints.push_back("first row is not evaluation 1");
  for (std::size_t k = 1; k < block.rows.size(); ++k) {
    if (block.rows[k].evaluations <= block.rows[k - 1].evaluations) {
      complaints.push_back("evaluations do not rise");
    }
    if (block.rows[k].optimality_gap > block.rows[k - 1].optimality_gap)
      complaints.push_back("optimality gap rises");
  }
}

std::vector<Block> blocks_of(const fs::path& file, int dimension, Complaints& complaints) {
  static const std::regex head(R"(.*Fopt \((-?[0-9]\.[0-9]{12}e[-+][0-9]{2,3})\).*)");
  static const std::regex evaluations("[1-9][0-9]* [0-9]+");
  static const std::regex value(R"([-+][0-9]+(\.[0-9]+)?(e[-+][0-9]+)?)");
  std::vector<Block> blocks;
  for (const std::string& line : lines_of(text_of(file))) {
    std::smatch match;
    if (line.starts_with('%')) {
      const bool right = std::regex_match(line, match, head) && line == header(match[1], dimension);
      if (!right) complaints.push_back("another header: " + line);
      blocks.push_back({right ? std::strtod(match[1].str().c_str(), nullptr) : 0, {}});
      continue;
    }
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; stream >> word;) words.push_back(word);
    // cocopp leaves out any other row: readalign.split asks for dimension + 5 words.
    bool right = static_cast<int>(words.size()) == dimension + 5 && !blocks.empty() &&
                 std::regex_match(words[0] + " " + words[1], evaluations);
    for (std::size_t k = 2; right && k < words.size(); ++k) {
      right = std::regex_match(words[k], value) || (k >= 5 && words[k] == "nan");
    }
    if (!right) {
      complaints.push_back("no row: " + line);
      continue;
    }
    CocoRow row{std::atoll(words[0].c_str()),
                std::strtod(words[2].c_str(), nullptr),
                std::strtod(words[3].c_str(), nullptr),
                {}};
    for (std::size_t k = 5; k < words.size(); ++k) {
      row.x.push_back(std::strtod(words[k].c_str(), nullptr));
    }
    blocks.back().rows.push_back(row);
  }
  for (const Block& block : blocks) check_rows(block, complaints);
  return blocks;
}

/// The runs of a case, as its third line tells of them.
void read_runs(const fs::path& root, const std::string& line, CocoCase& read,
               Complaints& complaints) {
  const std::string id = std::to_string(read.function_id);
  const std::string stem =
      "data_f" + id + "/bbobexp_f" + id + "_DIM" + std::to_string(read.dimension);
  if (!line.starts_with(stem + ".dat, ")) return complaints.push_back("no path of rows");
  if (!fs::exists(root / (stem + ".dat")) || !fs::exists(root / (stem + ".tdat"))) {
    return complaints.push_back("rows are missing");
  }
  const auto improvements = blocks_of(root / (stem + ".dat"), read.dimension, complaints);
  const auto counts = blocks_of(root / (stem + ".tdat"), read.dimension, complaints);
  static const std::regex entry(R"(, ([0-9]+):([0-9]+)\|(-?[0-9]\.[0-9]e[-+][0-9]{2,3}))");
  const std::string told = line.substr(stem.size() + 4);
  std::size_t length = 0;
  for (std::sregex_iterator it(told.begin(), told.end(), entry), end; it != end; ++it) {
    const std::size_t k = read.runs.size();
    length += static_cast<std::size_t>(it->length());
    if (k >= improvements.size() || k >= counts.size()) {
      complaints.push_back("not as many runs as in the rows");
      break;
    }
    const auto evaluations = std::atoll((*it)[2].str().c_str());
    const double optimality_gap = std::strtod((*it)[3].str().c_str(), nullptr);
    for (const Block* block : {&improvements[k], &counts[k]}) {
      if (block->rows.empty()) continue;
      if (block->rows.back().evaluations != evaluations) {
        complaints.push_back("rows do not end at the last evaluation");
      }
      const double last = block->rows.back().optimality_gap;
      if (std::abs(last - optimality_gap) > 0.06 * std::abs(last))
        complaints.push_back("another optimality gap");
    }
    read.runs.push_back({std::atoi((*it)[1].str().c_str()), improvements[k].fopt,
                         improvements[k].rows, counts[k].rows});
  }
  if (length != told.size()) complaints.push_back("no list of runs");
  if (read.runs.size() != improvements.size() || read.runs.size() != counts.size()) {
    complaints.push_back("not as many runs as in the rows");
  }
}

}  // namespace

std::vector<CocoCase> read_coco(const fs::path& root, Complaints& complaints) {
  static const std::regex first(
      R"(suite = 'bbob-mixint', funcId = ([0-9]+), DIM = ([0-9]+), Precision = 1\.000e-08, )"
      R"(algId = '([^', ]+)', coco_version = '2\.8\.0', logger = 'bbob', data_format = 'bbob-new2')");
  std::vector<CocoCase> cases;
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.is_directory()) continue;
    const auto lines = lines_of(text_of(entry.path()));
    std::set<int> dimensions;
    for (std::size_t k = 0; k < lines.size(); k += 4) {
      std::smatch match;
      if (lines.size() < k + 3 || !std::regex_match(lines[k], match, first) ||
          !lines[k + 1].starts_with("% ") || (lines.size() > k + 3 && !lines[k + 3].empty())) {
        complaints.push_back("no three lines");
        break;
      }
      CocoCase read{match[3], std::stoi(match[1]), std::stoi(match[2]), {}};
      if (entry.path().filename() != "bbobexp_f" + match[1].str() + ".info") {
        complaints.push_back("file has another name");
      }
      if (!dimensions.insert(read.dimension).second) complaints.push_back("a dimension twice");
      read_runs(root, lines[k + 2], read, complaints);
      cases.push_back(read);
    }
  }
  return cases;
}

}  // namespace ricochet::exports
