// Peer of the tasks `overlay-intersection` and `overlay-union`: Clipper2 on 64-bit integers.
//
// Usage: clipper2 intersection|union FILE.raw3. With the directory CPP/Clipper2Lib of its sources (version 2.0.1 was measured):
//
//     c++ -std=c++17 -O3 -march=native -DNDEBUG -I Clipper2Lib/include -o clipper2 \
//         crates/coface-bench/peers/clipper2.cpp Clipper2Lib/src/clipper.engine.cpp
//     coface-bench compare overlay-union coast_100000 --peer 'clipper2=./clipper2 union {}'
//
// Coordinates in the file are integers below 2^28. Reading is outside the clock; it starts with paths of integers and stops with the
// tree of resulting paths, which says what is a hole of what. What ends on a peak or in a line is kept as Clipper2 does by default.

#include <chrono>
#include <clipper2/clipper.engine.h>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <sys/resource.h>
#include <vector>

using namespace Clipper2Lib;

int main(int count, char **arguments) {
    FILE *file = count == 3 ? fopen(arguments[2], "rb") : nullptr;
    // Width of all rings or 0, vertices, rings; then the starts of rings unless they have one width, their vertices, coordinates.
    uint32_t header[3];
    if (!file || fread(header, 4, 3, file) != 3) return 1;
    std::vector<uint32_t> starts(header[2] + 1);
    if (header[0] == 0) {
        if (fread(starts.data(), 4, starts.size(), file) != starts.size()) return 1;
    } else {
        for (size_t i = 0; i < starts.size(); ++i) starts[i] = uint32_t(i) * header[0];
    }
    std::vector<uint32_t> vertices(starts.back());
    std::vector<double> points(3 * size_t(header[1]));
    if (fread(vertices.data(), 4, vertices.size(), file) != vertices.size()) return 1;
    if (fread(points.data(), 8, points.size(), file) != points.size()) return 1;
    fclose(file);
    Paths64 regions[2];
    for (size_t ring = 0; ring < header[2]; ++ring) {
        Path64 path;
        for (size_t i = starts[ring]; i < starts[ring + 1]; ++i) {
            const double *point = &points[3 * size_t(vertices[i])];
            path.emplace_back(std::llround(point[0]), std::llround(point[1]));
        }
        regions[points[3 * size_t(vertices[starts[ring]]) + 2] == 0.0 ? 0 : 1].push_back(std::move(path));
    }
    ClipType type = strcmp(arguments[1], "union") == 0 ? ClipType::Union : ClipType::Intersection;
    auto begin = std::chrono::steady_clock::now();
    clock_t begin_cpu = clock();
    Clipper64 clipper;
    clipper.AddSubject(regions[0]);
    clipper.AddClip(regions[1]);
    PolyTree64 tree;
    clipper.Execute(type, FillRule::NonZero, tree);
    double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    double cpu_seconds = double(clock() - begin_cpu) / CLOCKS_PER_SEC;
    size_t polygons = 0, rings = 0, corners = 0;
    std::vector<const PolyPath64 *> stack{&tree};
    while (!stack.empty()) {
        const PolyPath64 *node = stack.back();
        stack.pop_back();
        for (const auto &child : *node) stack.push_back(child.get());
        if (node->Parent()) {
            ++rings;
            polygons += !node->IsHole();
            corners += node->Polygon().size();
        }
    }
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    printf("{\"seconds\": %g, \"cpu_seconds\": %g, \"peak_mb\": %g, \"size\": %u, ", seconds, cpu_seconds, usage.ru_maxrss / 1024.0, header[1]);
    printf("\"result\": \"polygons %zu rings %zu vertices %zu area %.5f\"}\n", polygons, rings, corners, tree.Area() / std::ldexp(1.0, 54));
    return 0;
}
