// Peer of the task `arrangement`: the exact arrangement of segments of CGAL.
//
// Usage: arrangement FILE.raw3. Reading is outside the clock.
//
//     g++ -O3 -march=native -DNDEBUG crates/coface-bench/peers/arrangement.cpp -o arrangement -lgmp -lmpfr
//     coface-bench compare arrangement seg_100000 --peer 'cgal=PATH/arrangement {}'

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <vector>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Arr_segment_traits_2<Kernel> Traits;
typedef CGAL::Arrangement_2<Traits> Arrangement;

int main(int, char **arguments) {
    FILE *file = fopen(arguments[1], "rb");
    uint32_t header[3];
    if (!file || fread(header, 4, 3, file) != 3 || header[0] != 2) return 1;
    std::vector<uint32_t> ends(2 * header[2]);
    std::vector<double> points(3 * header[1]);
    if (fread(ends.data(), 4, ends.size(), file) != ends.size()) return 1;
    if (fread(points.data(), 8, points.size(), file) != points.size()) return 1;
    std::vector<Traits::X_monotone_curve_2> segments;
    for (size_t s = 0; s < header[2]; ++s) {
        const double *p = &points[3 * ends[2 * s]], *q = &points[3 * ends[2 * s + 1]];
        segments.emplace_back(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]));
    }
    auto begin = std::chrono::steady_clock::now();
    clock_t begin_cpu = clock();
    Arrangement arrangement;
    insert(arrangement, segments.begin(), segments.end());
    double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    double cpu_seconds = double(clock() - begin_cpu) / CLOCKS_PER_SEC;
    printf("{\"seconds\": %g, \"cpu_seconds\": %g, \"size\": %u, \"result\": \"V %zu E %zu F %zu\"}\n", seconds, cpu_seconds, header[2],
           size_t(arrangement.number_of_vertices()), size_t(arrangement.number_of_edges()),
           size_t(arrangement.number_of_faces() - arrangement.number_of_unbounded_faces()));
    return 0;
}
