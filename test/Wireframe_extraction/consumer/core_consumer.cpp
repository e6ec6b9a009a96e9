#include <CGAL/Simple_cartesian.h>
#include <CGAL/extract_wireframe.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

#ifndef CGAL_WIREFRAME_EXTRACTION_COMPILED
#error "the target does not say that the core is compiled"
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;

// Two squares that meet in an edge of length 2, with the exact distances to it.
int main()
{
  std::vector<std::pair<Point_3, double>> cloud;
  const double step = 0.02;
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 50; ++j)
    {
      const double jitter = 0.3 * step * std::sin(7. * i + 3. * j); // so that the points are no lattice
      cloud.emplace_back(Point_3(i * step + jitter, j * step, 0.), j * step);
      cloud.emplace_back(Point_3(i * step - jitter, 0., j * step + 0.5 * step), j * step + 0.5 * step);
    }
  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe(cloud);
  double longest = 0.;
  for (const auto& curve : wireframe.curves)
    longest = (std::max)(longest, curve.spline.length());
  if (std::abs(longest - 2.) > 0.1)
  {
    std::cerr << "the edge is " << longest << " long" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
