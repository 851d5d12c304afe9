// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"
#include "ui/settings/growth/AcceptedFronts.h"
#include "ui/settings/growth/GrowthPast.h"
#include "ui/settings/growth/SegmentIntervals.h"

#include <QObject>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// The sketched seeds that are not members of a growth: those that no growth has reached yet (on
/// the history's line up to its position, after the last growth), and those that growths have left
/// waiting because they do not meet the criteria. They are taken from the engine, so a place that
/// accepted no seed has none. Only seeds of shown segments, in all label planes. Part of Workspace.
class PendingSeeds : public QObject {
    Q_OBJECT

public:
    explicit PendingSeeds(Workspace& workspace);

    [[nodiscard]] const std::vector<gpu::SceneSeed>& seeds() const { return *m_seeds; }
    /// The seeds that growths have left waiting; they are drawn hollow.
    [[nodiscard]] const std::vector<gpu::SceneSeed>& hollow() const { return m_hollow; }
    /// Whether these are the seeds at the history's present position; else the engine is being
    /// asked.
    [[nodiscard]] bool isUpToDate() const { return !m_isAsking; }
    /// The seeds() for a picture of the 3D view.
    [[nodiscard]] std::shared_ptr<const std::vector<gpu::SceneSeed>> scene() const
    {
        return m_seeds;
    }

    /// Stores, for seeds of a sketch on the 3D view, the direction in index space in which the user
    /// looked at them. It is kept until another session is opened.
    /// @param seenAlong voxels with their directions; a voxel without one was sketched on a slice
    void noteSketch(int label, const std::vector<glm::ivec3>& voxels,
        const std::vector<std::pair<glm::ivec3, glm::dvec3>>& seenAlong);
    /// The stored direction of a seed; none: it was sketched on a slice, or before the session was
    /// opened.
    [[nodiscard]] std::optional<glm::dvec3> seenAlong(int label, const glm::ivec3& voxel) const;

    /// About what a growth from these seeds would take, as slices (areas) and the 3D view (bodies)
    /// draw it where no chunks are shown; null: nothing.
    struct Ghost {
        std::shared_ptr<const gpu::SceneChunks> areas;
        std::shared_ptr<const gpu::SceneChunks> bodies;
        bool operator==(const Ghost&) const = default;
    };
    [[nodiscard]] const Ghost& ghost() const { return m_ghost; }
    /// Shows one (GrowthGhost).
    void setGhost(const Ghost& ghost);

    /// The interval of each segment; it follows additions and removals of segments.
    [[nodiscard]] SegmentIntervals& intervals() { return m_intervals; }
    /// What the history of the open session says of growth.
    [[nodiscard]] GrowthPast& past() { return m_past; }
    /// The fronts that are no leaks, and so what growth asks about from now on.
    [[nodiscard]] AcceptedFronts& acceptedFronts() { return m_acceptedFronts; }

Q_SIGNALS:
    void changed();
    void updated(); ///< isUpToDate() is true, whether or not they have changed
    void ghostChanged();

private:
    struct Sketched;

    /// The seeds that, by the history, may be waiting.
    [[nodiscard]] static Sketched seedsOf(const core::EditSession& session);
    void update();
    /// Asks the engine which of them really wait, and shows those.
    void show(Sketched sketched);
    void set(std::vector<gpu::SceneSeed> pending, std::vector<gpu::SceneSeed> hollow);

    Workspace& m_workspace;
    std::shared_ptr<const std::vector<gpu::SceneSeed>> m_seeds;
    std::vector<gpu::SceneSeed> m_hollow;
    Ghost m_ghost;
    std::map<std::array<int, 4>, glm::dvec3> m_seenAlong; ///< by label, x, y, z
    SegmentIntervals m_intervals;
    GrowthPast m_past;
    AcceptedFronts m_acceptedFronts;
    std::uint64_t m_asked = 0; ///< number of questions; only the answer to the last one counts
    bool m_isAsking = false; ///< it has not come yet
};

} // namespace ui
