// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/CrossingGuard.h"

#include "core/base/Progress.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

/// The share of its way that a vertex may go: at first, after its faces have crossed once, and
/// after they have crossed twice.
constexpr std::array<double, 3> shareOfWay{1.0, 0.5, 0.0};

template <typename Id> void sortUnique(std::vector<Id>& ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

} // namespace

CrossingGuard::CrossingGuard(
    const SimplexMesh& mesh, const VolumeGeometry& geometry, const Progress* progress)
    : m_mesh(mesh)
    , m_progress(progress)
    , m_grid(mesh, geometry, progress)
    , m_safe(mesh.positions().begin(), mesh.positions().end())
{
}

bool CrossingGuard::isCancelled() const
{
    return m_progress && m_progress->cancelled();
}

void CrossingGuard::moved(std::span<const VertexId> vertices)
{
    m_isMoved.resize(std::max<std::size_t>(m_isMoved.size(), m_mesh.vertexSlots()), false);
    for (const VertexId id : vertices) {
        // A vertex that is no longer there may be beyond the slots.
        if (id >= m_isMoved.size() || m_isMoved[id])
            continue;
        m_isMoved[id] = true;
        m_moved.push_back(id);
    }
}

double CrossingGuard::movedMm() const
{
    double most = 0.0;
    for (const VertexId id : m_moved) {
        if (m_mesh.hasVertex(id))
            most = std::max(most, glm::distance(m_mesh.position(id), m_safe[id]));
    }
    return most;
}

std::vector<FaceId> CrossingGuard::facesAt(std::span<const VertexId> vertices) const
{
    std::vector<FaceId> faces;
    for (const VertexId id : vertices)
        faces.insert(faces.end(), m_mesh.facesAt(id).begin(), m_mesh.facesAt(id).end());
    sortUnique(faces);
    return faces;
}

void CrossingGuard::forgetKnown(std::vector<CrossingFaces>& crossings) const
{
    std::erase_if(crossings, [this](const CrossingFaces& pair) { return m_known.count(pair) > 0; });
}

void CrossingGuard::dropKnown(
    std::span<const FaceId> written, std::span<const CrossingFaces> crossings)
{
    const auto isWritten = [written](FaceId face) {
        return std::binary_search(written.begin(), written.end(), face);
    };
    std::erase_if(m_known, [&](const CrossingFaces& pair) {
        return (isWritten(pair.one) || isWritten(pair.other))
            && !std::binary_search(crossings.begin(), crossings.end(), pair);
    });
}

std::vector<VertexId> CrossingGuard::keepApart(SimplexMeshEdit& edit)
{
    for (const VertexId id : m_moved)
        m_isMoved[id] = false;
    std::sort(m_moved.begin(), m_moved.end());
    std::erase_if(m_moved,
        [this](VertexId id) { return !m_mesh.hasVertex(id) || m_mesh.position(id) == m_safe[id]; });
    if (m_moved.empty())
        return {};
    std::vector<glm::dvec3> targets;
    targets.reserve(m_moved.size());
    for (const VertexId id : m_moved)
        targets.push_back(m_mesh.position(id));
    std::vector<std::uint8_t> levels(m_moved.size(), 0);
    const auto indexOf = [this](VertexId id) {
        const auto found = std::lower_bound(m_moved.begin(), m_moved.end(), id);
        return found != m_moved.end() && *found == id ? std::size_t(found - m_moved.begin())
                                                      : m_moved.size();
    };
    for (std::vector<FaceId> faces = facesAt(m_moved); !faces.empty();) {
        m_grid.refresh(faces);
        std::vector<CrossingFaces> crossings = m_grid.crossingsOf(faces);
        if (isCancelled())
            return {};
        forgetKnown(crossings);
        std::vector<VertexId> shortened;
        for (const CrossingFaces& pair : crossings) {
            bool isMoved = false;
            for (const FaceId face : {pair.one, pair.other}) {
                for (const VertexId id : m_mesh.ring(face)) {
                    const std::size_t i = indexOf(id);
                    if (i == m_moved.size() || levels[i] + 1U == shareOfWay.size())
                        continue;
                    isMoved = true;
                    shortened.push_back(id);
                }
            }
            if (!isMoved)
                m_known.insert(pair);
        }
        sortUnique(shortened);
        for (const VertexId id : shortened) {
            const std::size_t i = indexOf(id);
            const double share = shareOfWay[++levels[i]];
            edit.move(
                id, share > 0.0 ? m_safe[id] + share * (targets[i] - m_safe[id]) : m_safe[id]);
        }
        faces = facesAt(shortened);
    }
    std::vector<VertexId> shortened;
    for (std::size_t i = 0; i < m_moved.size(); ++i) {
        m_safe[m_moved[i]] = m_mesh.position(m_moved[i]);
        if (levels[i] > 0)
            shortened.push_back(m_moved[i]);
    }
    m_moved.clear();
    return shortened;
}

bool CrossingGuard::concludes(SimplexMeshEdit& edit, bool isChanged)
{
    const std::vector<FaceId> written = edit.trialFaces();
    if (!isChanged) {
        edit.revertTrial();
        return false;
    }
    std::vector<FaceId> faces = written;
    std::erase_if(faces, [this](FaceId face) { return !m_mesh.hasFace(face); });
    m_grid.refresh(written);
    const std::vector<CrossingFaces> all = m_grid.crossingsOf(faces);
    std::vector<CrossingFaces> crossings = all;
    forgetKnown(crossings);
    if (!crossings.empty()) {
        edit.revertTrial();
        m_grid.refresh(written);
        return false;
    }
    edit.keepTrial();
    dropKnown(written, all);
    remember(faces);
    return true;
}

void CrossingGuard::remember(std::span<const FaceId> faces)
{
    m_safe.resize(std::max<std::size_t>(m_safe.size(), m_mesh.vertexSlots()));
    for (const FaceId face : faces) {
        for (const VertexId id : m_mesh.ring(face))
            m_safe[id] = m_mesh.position(id);
    }
}

} // namespace core
