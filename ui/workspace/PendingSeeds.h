// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

class Workspace;

/// The sketched seeds that are no members: those that no growth has come to yet (of the history's
/// line up to its position, after the last growth), and those that growths have left waiting, since
/// they do not qualify; as the engine holds them, so a place that took no seed has none. Of
/// segments that are shown. Part of Workspace.
class PendingSeeds : public QObject {
    Q_OBJECT

public:
    explicit PendingSeeds(Workspace& workspace);

    [[nodiscard]] const std::vector<gpu::SceneSeed>& seeds() const { return *m_seeds; }
    /// Those that growths have left waiting; drawn hollow.
    [[nodiscard]] const std::vector<gpu::SceneSeed>& hollow() const { return m_hollow; }
    /// The first for a picture of the 3D view.
    [[nodiscard]] std::shared_ptr<const std::vector<gpu::SceneSeed>> scene() const
    {
        return m_seeds;
    }

Q_SIGNALS:
    void changed();

private:
    struct Sketched;

    /// Those that the history says may wait.
    [[nodiscard]] static Sketched seedsOf(const core::EditSession& session);
    void update();
    /// Asks which of them wait indeed, and shows those.
    void show(Sketched sketched);
    void set(std::vector<gpu::SceneSeed> pending, std::vector<gpu::SceneSeed> hollow);

    Workspace& m_workspace;
    std::shared_ptr<const std::vector<gpu::SceneSeed>> m_seeds;
    std::vector<gpu::SceneSeed> m_hollow;
    std::uint64_t m_asked = 0; ///< questions; only the last counts
};

} // namespace ui
