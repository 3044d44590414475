#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "functions/internals.h"
#include "tests/support/catch.h"

using namespace durer;
using namespace durer::functions;

namespace {

struct Row {
  int number = 0;
  std::vector<double> arguments;  // x, y, z, then the parameters
  double value = 0;
};

std::vector<Row> oracle_rows() {
  std::ifstream file(DURER_TEST_DATA "/internals.tsv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
    Row row;
    row.number = std::stoi(fields.at(0));
    for (int i = 2; i < 5; ++i) row.arguments.push_back(std::stod(fields.at(i)));
    std::istringstream parameters(fields[1]);
    for (double p = 0; parameters >> p;) row.arguments.push_back(p);
    row.value = std::stod(fields.at(5));
    rows.push_back(row);
  }
  return rows;
}

/// One line per parameter set of the table.
std::vector<Row> parameter_sets() {
  std::vector<Row> sets;
  for (Row& row : oracle_rows()) {
    const auto same_parameters = [&](const Row& s) {
      return s.number == row.number &&
             std::equal(s.arguments.begin() + 3, s.arguments.end(), row.arguments.begin() + 3);
    };
    if (sets.empty() || !same_parameters(sets.back())) sets.push_back(row);
  }
  return sets;
}

std::string_view name(const Row& row) { return internal_functions[row.number].name; }

double value_at(const Row& row, const dvec3& p) {
  std::vector<double> a = row.arguments;
  for (int i = 0; i < 3; ++i) a[i] = p[i];
  return internal_value(row.number, a.data(), Context{});
}

dvec3 random_point(std::mt19937& rng, double size) {
  std::uniform_real_distribution<double> u(-size, size);
  return {u(rng), u(rng), u(rng)};
}

}  // namespace

TEST_CASE("internal functions: all values of the reference table", "[functions][internals]") {
  const auto rows = oracle_rows();
  REQUIRE(rows.size() > 800);
  std::vector<bool> seen(internal_functions.size());
  double worst = 0;
  for (const Row& row : rows) {
    REQUIRE(static_cast<int>(row.arguments.size()) == 3 + internal_functions[row.number].extra);
    seen[row.number] = true;
    const double v = internal_value(row.number, row.arguments.data(), Context{});
    const double error = std::abs(v - row.value) / std::max(1e-6, std::abs(row.value));
    if (!(error < 1e-9)) {
      CAPTURE(name(row), row.arguments, v, row.value);
      CHECK(false);
    }
    worst = std::max(worst, error);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK(seen[i]);
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("internal functions: a batch gives the bits of its points", "[functions][internals]") {
  std::mt19937 rng(3);
  for (const Row& row : parameter_sets()) {
    for (int repeat = 0; repeat < 10; ++repeat) {
      std::vector<Pack> a(row.arguments.begin(), row.arguments.end());
      std::vector<dvec3> points(Pack::lanes);
      for (int lane = 0; lane < Pack::lanes; ++lane) {
        points[lane] = lane == 0 && repeat == 0 ? dvec3(0.0) : random_point(rng, 2.0);
        for (int i = 0; i < 3; ++i) a[i].v[lane] = points[lane][i];
      }
      const Pack r = internal_value(row.number, a.data(), Context{});
      for (int lane = 0; lane < Pack::lanes; ++lane) {
        const double v = value_at(row, points[lane]);
        if (!(r.v[lane] == v || (v != v && r.v[lane] != r.v[lane]))) {
          CAPTURE(name(row), lane, v, r.v[lane]);
          CHECK(false);
        }
      }
    }
  }
}

TEST_CASE("internal functions: a batch with parameters that vary by lane",
          "[functions][internals]") {
  const auto rows = oracle_rows();
  for (std::size_t first = 0; first < rows.size(); first += 7) {
    // The sets of one function that follow each other share a batch, lane by lane.
    std::vector<Row> lanes;
    for (std::size_t i = first; i < rows.size() && lanes.size() < Pack::lanes; i += 5) {
      if (rows[i].number == rows[first].number) lanes.push_back(rows[i]);
    }
    while (lanes.size() < Pack::lanes) lanes.push_back(lanes.front());
    std::vector<Pack> a(rows[first].arguments.size());
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      for (std::size_t i = 0; i < a.size(); ++i) a[i].v[lane] = lanes[lane].arguments[i];
    }
    const Pack r = internal_value(rows[first].number, a.data(), Context{});
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      const double v = internal_value(rows[first].number, lanes[lane].arguments.data(), Context{});
      if (!(r.v[lane] == v)) {
        CAPTURE(name(rows[first]), lane, v, r.v[lane]);
        CHECK(false);
      }
    }
  }
}

TEST_CASE("internal functions: intervals enclose sampled points",
          "[functions][internals][interval]") {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(0, 1);
  for (const Row& row : parameter_sets()) {
    for (int repeat = 0; repeat < 60; ++repeat) {
      const dvec3 corner = random_point(rng, 2.0);
      const double size = std::pow(10.0, -4 + 5 * u(rng));
      std::vector<Interval> a(row.arguments.begin(), row.arguments.end());
      for (int i = 0; i < 3; ++i) a[i] = {corner[i], corner[i] + size};
      const Interval r = internal_value(row.number, a.data(), Context{});
      for (int k = 0; k < 25; ++k) {
        const dvec3 p = k == 0 ? corner : corner + size * dvec3(u(rng), u(rng), u(rng));
        const double v = value_at(row, p);
        if (!r.contains(v)) {
          CAPTURE(name(row), row.arguments, p.x, p.y, p.z, size, v, r.lo, r.hi);
          CHECK(false);
          break;
        }
      }
    }
  }
}

TEST_CASE("internal functions: an interval that is a point gives the value",
          "[functions][internals][interval]") {
  for (const Row& row : oracle_rows()) {
    const std::vector<Interval> a(row.arguments.begin(), row.arguments.end());
    const Interval r = internal_value(row.number, a.data(), Context{});
    const double v = internal_value(row.number, row.arguments.data(), Context{});
    if (!(r.contains(v) && r.hi - r.lo <= 1e-12 * std::max(1.0, std::abs(v)))) {
      CAPTURE(name(row), row.arguments, v, r.lo, r.hi);
      CHECK(false);
    }
  }
}

TEST_CASE("internal functions: gradients agree with differences",
          "[functions][internals][gradient]") {
  std::mt19937 rng(6);
  for (const Row& row : parameter_sets()) {
    int wrong = 0;
    double got = 0;
    double expected = 0;
    for (int repeat = 0; repeat < 100; ++repeat) {
      const dvec3 p = random_point(rng, 1.7);
      std::vector<Dual> a(row.arguments.begin(), row.arguments.end());
      for (int i = 0; i < 3; ++i) {
        a[i] = p[i];
        a[i].d[i] = 1;
      }
      const Dual r = internal_value(row.number, a.data(), Context{});
      if (r.v != value_at(row, p)) {
        CAPTURE(name(row), r.v, value_at(row, p));
        CHECK(false);
      }
      for (int i = 0; i < 3; ++i) {
        dvec3 h{0.0};
        h[i] = 1e-5;
        const double d = (value_at(row, p + h) - value_at(row, p - h)) / 2e-5;
        if (std::abs(r.d[i] - d) > 2e-2 * std::max(1.0, std::abs(d))) {
          ++wrong;
          got = r.d[i];
          expected = d;
        }
      }
    }
    if (wrong > 2) {  // a sample next to a kink or jump is no evidence
      CAPTURE(name(row), row.arguments, wrong, got, expected);
      CHECK(false);
    }
  }
}
