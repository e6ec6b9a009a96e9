#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;

// What is wrong with a file is said by the reader if there is one, else that the program was built without it.
int main()
{
  std::ofstream("cloud.h5") << "no cloud";
  std::vector<std::pair<Kernel::Point_3, double>> cloud;
  std::string error;
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  const bool is_read = CGAL::IO::read_distance_cloud("cloud.h5", cloud, parameters::error_message(&error));
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  const char* const expected = "no HDF5 file";
#else
  const char* const expected = "libhdf5-dev";
#endif
  if (is_read || error.find(expected) == std::string::npos)
  {
    std::cerr << "not as expected: " << error << std::endl;
    return EXIT_FAILURE;
  }
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  std::cout << "with zlib " << zlibVersion() << std::endl;
#endif
  return EXIT_SUCCESS;
}
