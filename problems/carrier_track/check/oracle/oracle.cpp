#include "problems/carrier_track/check/oracle/oracle.h"

#include "problems/carrier_track/check/oracle/body.h"

namespace ricochet::carrier_track::inline oracle {

OracleRun oracle_run(const Scene& scene) {
  return of_body::Body(scene, Push(scene)).run();
}

OracleRun oracle_run(const Scene& scene, const TermPush& push) {
  return of_body::Body(scene, push).run();
}

}  // namespace ricochet::carrier_track::inline oracle
