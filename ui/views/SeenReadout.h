// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <QObject>

#include <optional>

namespace ui {

class Workspace;

/// Finds the voxel that is seen under the pointer in a 3D view, at its true place, for
/// Workspace::pointedLps(). It asks the engine, one question at a time, and never waits for it.
class SeenReadout : public QObject {
    Q_OBJECT

public:
    explicit SeenReadout(Workspace& workspace, QObject* parent = nullptr);

    /// @param planeMm in the view plane, right of and above the target
    void pointAt(const gpu::VolumeScene& scene, const glm::dvec2& planeMm);
    /// The pointer has left the view: answers under way are dropped.
    void leave();

private:
    struct Place {
        gpu::VolumeScene scene;
        glm::dvec2 planeMm{0.0};
    };
    void ask(const Place& place);

    Workspace& m_workspace;
    std::optional<Place> m_next; ///< the place pointed at since the question was asked
    bool m_asking = false;
    int m_asked = 0; ///< number of questions; only the answer to the latest one is used
};

} // namespace ui
