#include "elasticity/vertex_graph.hpp"

#include <memory>

#include "base/conjugate_gradients.hpp"

namespace taut {
namespace {

using Use = VertexGraph::Use;

Buckets<Use> uses_of(const TetMesh& mesh) {
  return gather<Use>(mesh.tets.size(), mesh.vertices.size(), [&](std::size_t t, auto put) {
    const Tet& tet = mesh.tets[t];
    if (!tet.alive()) return;
    for (std::uint32_t k = 0; k < 4; ++k) put(tet.v[k], Use{static_cast<TetId>(t), k, {}});
  });
}

// Where in the row that is being filled each vertex has its column. Rows that were filled before need not be cleared.
class Row {
public:
  explicit Row(std::size_t vertices) : seen_(vertices) {}

  void start(std::size_t i) {
    mark_ = static_cast<std::uint32_t>(i) + 1;
    length_ = 0;
  }
  /// Of a vertex that is seen the first time, a new place.
  std::uint32_t place(VertexId v, std::vector<std::uint32_t>& columns) {
    Seen& seen = seen_[v];
    if (seen.mark != mark_) {
      seen = {mark_, length_++};
      columns.push_back(v);
    }
    return seen.place;
  }

private:
  struct Seen {
    std::uint32_t mark = 0, place = 0;
  };
  std::vector<Seen> seen_;
  std::uint32_t mark_ = 0, length_ = 0;
};

}  // namespace

VertexGraph::VertexGraph(const TetMesh& mesh) : uses_(uses_of(mesh)), first_(mesh.vertices.size() + 1, 0) {
  std::vector<std::unique_ptr<Row>> of_worker(static_cast<std::size_t>(worker_count()));
  columns_ = collect_in_order<std::uint32_t>(chunks_of_rows(size()),
                                             [&](std::vector<std::uint32_t>& list, std::size_t i, int worker) {
                                               auto& row = of_worker[static_cast<std::size_t>(worker)];
                                               if (!row) row = std::make_unique<Row>(size());
                                               const std::size_t before = list.size();
                                               row->start(i);
                                               (void)row->place(static_cast<VertexId>(i), list);
                                               for (Use& use : uses_[i])
                                                 for (std::size_t k = 0; k < 4; ++k)
                                                   use.place[k] = row->place(mesh.tets[use.tet].v[k], list);
                                               first_[i + 1] = list.size() - before;
                                             });
  for (std::size_t i = 0; i < size(); ++i) first_[i + 1] += first_[i];
}

}  // namespace taut
