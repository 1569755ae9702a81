#include "tests/report/points_sample.h"

namespace desmo::report {
namespace {

Json level_errors(double position) {
  const auto max = [](double error) { return Json{{"max", error}}; };
  return {{"position", max(position)},
          {"velocity", max(2 * position)},
          {"acceleration", max(4 * position)}};
}

Json series(const std::string& case_name, int coordinates, double step, int instants) {
  return {{"case", case_name},
          {"coordinates", coordinates},
          {"step_seconds", step},
          {"instants", instants}};
}

Json moved(Json point, const Json& to) {
  point.update(to);
  return point;
}

Json unsolved_point(const std::string& id, const char* status, const char* message) {
  Json point = series(truck, 225, 0.01, 101);
  point["id"] = id;
  point["status"] = status;
  point["message"] = message;
  return point;
}

Json floor_of(Json floor) {
  floor["reference"] = levels(4e-33, 5e-33, 6e-33);
  floor["condition"] = 1000.0;
  floor["limit"] = {{"double", levels(1.1e-13, 1.1e-10, 1.1e-7)},
                    {"float", levels(6e-5, 6e-2, 60)}};
  return floor;
}

}  // namespace

Json solved_point(const std::string& id, double microseconds, double error, double iterations) {
  Json point = series(truck, 225, 0.01, 101);
  point["id"] = id;
  point["status"] = "ok";
  point["error"] = level_errors(error);
  point["iterations_per_step"] = iterations;
  point["time_per_step"] = step_time(microseconds);
  return point;
}

Json& point_of(Json& record, const std::string& id) {
  return element_with(record["accuracy"]["points"],
                      {{"coordinates", 225}, {"step_seconds", 0.01}, {"id", id}});
}

Json points_record() {
  Json record = empty_record();
  record["record"]["settings"]["tolerance"] = 1e-12;
  set_motion(record, 1);
  const std::string klu = "global_automatic_klu", lapack = "group_symbolic_lapack";
  Json points = {solved_point(klu, 40, 1e-15, 3.03),
                 solved_point(klu + "/iterations:1", 20, 5e-5),
                 solved_point(klu + "/iterations:2", 30, 2e-9, 2.02),
                 solved_point(klu + "/tolerance:1e-6", 31, 1.5e-9, 2.1),
                 solved_point(klu + "/tolerance:1e-8", 32, 5e-10, 2.2),
                 solved_point(klu + "/guess:hermite5", 28, 2e-15, 1.5),
                 solved_point(klu + "/guess:hermite5/tolerance:1e-8", 24, 9e-13),
                 solved_point(klu + "/guess:hermite5/jacobian:step/iterations:1", 16, 8e-10),
                 unsolved_point(klu + "/scalar:float", "not_applicable",
                                "the sparse library klu factorises in double precision"),
                 solved_point(lapack, 100, 2e-14, 3.03),
                 solved_point(lapack + "/iterations:1", 60, 4e-5),
                 solved_point(lapack + "/tolerance:1e-6", 85, 1e-7, 2.1),
                 solved_point(lapack + "/guess:hermite5", 80, 1e-14, 1.5),
                 solved_point(lapack + "/scalar:float/tolerance:1e-4", 50, 3e-6, 2.0),
                 unsolved_point(lapack + "/scalar:float", "failed",
                                "no convergence at t = 0.01 s, residual 1e-06, group 'axle1/i'"),
                 solved_point(lapack + "/scalar:mixed", 90, 3e-14, 3.03),
                 solved_point("group_automatic_klu", 39, 1e-14, 3.03),
                 solved_point("group_automatic_klu/tolerance:1e-6", 33, 1e-9, 2.1)};
  const Json small = series(truck, 114, 0.01, 101), bars = series("four_bar", 114, 0.01, 101),
             fine = series(truck, 225, 0.001, 1001);
  points.push_back(moved(solved_point(klu, 20, 1e-15), small));
  points.push_back(moved(solved_point(klu, 12, 1e-15), bars));
  points.push_back(moved(solved_point("group_symbolic_inlined", 2, 1e-15), bars));
  points.push_back(moved(solved_point(klu, 30, 1e-15, 2.02), fine));
  points.push_back(moved(solved_point(lapack, 75, 1e-14, 2.02), fine));
  points.push_back(moved(solved_point("group_automatic_klu", 36, 1e-14, 2.02), fine));
  record["accuracy"]["floors"] = {floor_of(series(truck, 225, 0.01, 101)), floor_of(small),
                                  floor_of(bars), floor_of(fine)};
  record["accuracy"]["points"] = std::move(points);
  return record;
}

}  // namespace desmo::report
