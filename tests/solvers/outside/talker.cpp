// A solver that is a program, as the tests need it: random search from the seed that it is told.
//   talker          a point at a time
//   talker BATCH    so many points at a time

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

json next_line() {
  std::string line;
  std::getline(std::cin, line);
  return std::cin ? json::parse(line) : json();
}

std::vector<double> drawn(const json& problem, std::mt19937_64& random) {
  std::vector<double> x;
  for (std::size_t i = 0; i < problem["lower"].size(); ++i) {
    const double low = problem["lower"][i], high = problem["upper"][i];
    x.push_back(low + (high - low) * (static_cast<double>(random()) * 0x1p-64));
  }
  return x;
}

}  // namespace

int main(int argc, char** argv) {
  const int batch = argc > 1 ? std::atoi(argv[1]) : 1;
  std::cout << json{{"name", "talker"}, {"version", "2"}, {"stochastic", true}} << std::endl;
  for (json problem = next_line(); !problem.is_null(); problem = next_line()) {
    std::mt19937_64 random(problem["seed"].get<std::uint64_t>());
    json answer;
    while (!answer.contains("stop")) {
      json asked = json::array();
      for (int k = 0; k < batch; ++k) asked.push_back(drawn(problem, random));
      std::cout << json{{"ask", argc > 1 ? asked : asked[0]}} << std::endl;
      answer = next_line();
    }
    std::cout << json{{"done", "told to stop"}} << std::endl;
  }
  return 0;
}
