// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/aim/SurfacePatch.h"
#include "ui/workspace/Workspace.h"

#include <functional>
#include <memory>
#include <optional>

namespace ui {

/// The surface under a tool's footprint before the tool is pressed. Questions go to the engine one
/// at a time; nothing waits, and the preview follows the pointer as fast as answers arrive.
class SurfacePreview {
public:
    /// @param changed called when there is something new to show
    SurfacePreview(Workspace& workspace, std::function<void()> changed);

    /// @param outlineMm in the view plane, right of and above the target
    void lookAt(const ViewContext& view, std::vector<glm::dvec2> outlineMm, int across);
    void forget();

    /// The latest answer; null if there is none yet.
    [[nodiscard]] const SurfacePatch* patch() const { return m_patch ? &*m_patch : nullptr; }

private:
    struct Wish {
        gpu::VolumeScene scene;
        std::vector<glm::dvec2> outlineMm;
        int across = 1;
    };
    void ask(Wish wish);

    Workspace& m_workspace;
    std::function<void()> m_changed;
    std::optional<SurfacePatch> m_patch;
    std::optional<Wish> m_next; ///< asked after the question under way is answered
    /// Set while a question is under way; dropping it makes the answer void.
    std::shared_ptr<int> m_asking;
};

} // namespace ui
