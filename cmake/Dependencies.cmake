# Everything comes from Debian 12; the script `ricochet` lists the packages.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Ceres 2.1 REQUIRED)
add_library(ricochet_dual_numbers INTERFACE)  # ceres/jet.h: headers alone
target_include_directories(ricochet_dual_numbers SYSTEM INTERFACE
  $<TARGET_PROPERTY:Ceres::ceres,INTERFACE_INCLUDE_DIRECTORIES>)
# With both NLopt packages installed a plain search finds the C build, which lacks StoGO and AGS.
find_package(NLopt 2.7 CONFIG REQUIRED NO_DEFAULT_PATH
             PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/nlopt_cxx)
find_package(Boost 1.74 REQUIRED)  # headers: Odeint, Math
find_package(Pagmo 2.18 REQUIRED)
find_package(SUNDIALS 6.4 REQUIRED COMPONENTS cvode nvecserial)
pkg_check_modules(Ipopt REQUIRED IMPORTED_TARGET ipopt)
find_package(TBB REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(pugixml 1.13 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(benchmark 1.7 REQUIRED)
