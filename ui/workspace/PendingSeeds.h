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
    std::uint64_t m_asked = 0; ///< number of questions; only the answer to the last one counts
};

} // namespace ui
