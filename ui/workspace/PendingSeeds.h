// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QObject>

#include <cstdint>
#include <glm/glm.hpp>

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
/// accepted no seed has none. Only seeds of shown segments. Part of Workspace.
class PendingSeeds : public QObject {
    Q_OBJECT

public:
    explicit PendingSeeds(Workspace& workspace);

    [[nodiscard]] const std::vector<gpu::SceneSeed>& seeds() const { return *m_seeds; }
    /// The seeds that growths have left waiting; they are drawn hollow.
    [[nodiscard]] const std::vector<gpu::SceneSeed>& hollow() const { return m_hollow; }
    /// The seeds() for a picture of the 3D view.
    [[nodiscard]] std::shared_ptr<const std::vector<gpu::SceneSeed>> scene() const
    {
        return m_seeds;
    }

    /// Remembers along which direction of the volume's index space the user looked when sketching
    /// these voxels on the 3D view; until another session is opened.
    void noteSeenAlong(const std::vector<glm::ivec3>& voxels, const glm::dvec3& direction);
    /// The direction for such a sketch; none: it was drawn on a slice, or before.
    [[nodiscard]] std::optional<glm::dvec3> seenAlong(const std::vector<glm::ivec3>& voxels) const;

Q_SIGNALS:
    void changed();

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
    std::vector<std::pair<std::vector<glm::ivec3>, glm::dvec3>> m_seenAlong;
    std::uint64_t m_asked = 0; ///< number of questions; only the answer to the last one counts
};

} // namespace ui
