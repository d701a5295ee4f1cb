// Peer of the tasks `solid-union` and `solid-intersection`: corefinement of CGAL on two closed meshes of triangles.
//
//     c++ -O3 -march=native -o corefinement crates/coface-bench/peers/corefinement.cpp -lgmp -lmpfr
//     coface-bench compare solid-union spheres8 --peer 'cgal=./corefinement union {}'
//
// The file (raw3) holds both meshes, the first half of the vertices and triangles being the first one. The clock starts
// with arrays and stops with the resulting mesh.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

static Mesh build(const double* points, std::size_t vertex_count, const std::uint32_t* triangles, std::size_t count,
                  std::uint32_t first) {
    Mesh mesh;
    mesh.reserve(vertex_count, 3 * vertex_count, count);
    for (std::size_t v = 0; v < vertex_count; ++v)
        mesh.add_vertex(Kernel::Point_3(points[3 * v], points[3 * v + 1], points[3 * v + 2]));
    for (std::size_t t = 0; t < count; ++t)
        mesh.add_face(Mesh::Vertex_index(triangles[3 * t] - first), Mesh::Vertex_index(triangles[3 * t + 1] - first),
                      Mesh::Vertex_index(triangles[3 * t + 2] - first));
    return mesh;
}

int main(int count, char** words) {
    if (count != 3) return 2;
    const std::string operation = words[1];
    std::ifstream file(words[2], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::uint32_t header[3];
    if (bytes.size() < sizeof header) return 1;
    std::memcpy(header, bytes.data(), sizeof header);
    std::vector<std::uint32_t> triangles(std::size_t{header[0]} * header[2]);
    std::vector<double> points(std::size_t{3} * header[1]);
    std::memcpy(triangles.data(), bytes.data() + 12, 4 * triangles.size());
    std::memcpy(points.data(), bytes.data() + 12 + 4 * triangles.size(), 8 * points.size());
    const std::size_t half_points = header[1] / 2, half = header[2] / 2;

    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t begin_cpu = std::clock();
    Mesh first = build(points.data(), half_points, triangles.data(), half, 0);
    Mesh second =
        build(points.data() + 3 * half_points, half_points, triangles.data() + 3 * half, half, half_points);
    Mesh result;
    const bool is_union = operation == "union";
    const bool done = is_union ? processing::corefine_and_compute_union(first, second, result)
                               : processing::corefine_and_compute_intersection(first, second, result);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double cpu_seconds = double(std::clock() - begin_cpu) / CLOCKS_PER_SEC;
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    std::printf("{\"seconds\": %.9g, \"cpu_seconds\": %.9g, \"peak_mb\": %.1f, \"size\": %u, "
                "\"result\": \"volume %.12g F %zu%s\"}\n",
                seconds, cpu_seconds, usage.ru_maxrss / 1024.0, header[2], CGAL::to_double(processing::volume(result)),
                result.number_of_faces(), done ? "" : " failed");
}
