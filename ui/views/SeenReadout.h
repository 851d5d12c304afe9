// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <QObject>

#include <optional>

namespace ui {

class Workspace;

/// Where the pointer points at in a 3D view: the voxel that is seen there, at its true place, for
/// Workspace::pointedLps(). Asks the engine, one question at a time, and never waits for it.
class SeenReadout : public QObject {
    Q_OBJECT

public:
    explicit SeenReadout(Workspace& workspace, QObject* parent = nullptr);

    /// @param planeMm in the view plane, right of and above the target
    void pointAt(const gpu::VolumeScene& scene, const glm::dvec2& planeMm);
    /// The pointer is elsewhere: answers under way mean nothing any more.
    void leave();

private:
    struct Place {
        gpu::VolumeScene scene;
        glm::dvec2 planeMm{0.0};
    };
    void ask(const Place& place);

    Workspace& m_workspace;
    std::optional<Place> m_next; ///< pointed at since the question was asked
    bool m_asking = false;
    int m_asked = 0; ///< questions; an answer to another than the last is dropped
};

} // namespace ui
