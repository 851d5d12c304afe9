// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QObject>

#include <optional>
#include <vector>

namespace core {
struct Volume;
}

namespace ui {

class Workspace;

/// Each voxel once, in the order of its first mention.
[[nodiscard]] std::vector<glm::ivec3> uniqueVoxels(const std::vector<glm::ivec3>& voxels);

/// Neighbouring points of a sketch lie at most so far apart, half a voxel: none is stepped over.
[[nodiscard]] double sketchStepPixels(const core::Volume& volume, const ViewContext& view);

/// Voxels under a path on a slice, each once; what lies outside the volume is left out.
/// @param path logical pixels
[[nodiscard]] std::vector<glm::ivec3> voxelsUnder(
    const std::vector<glm::dvec2>& path, const ViewContext& slice, const core::Volume& volume);

/// Points of the view plane along a path on the 3D view, as askWhatIsSeen() takes them.
[[nodiscard]] std::vector<glm::dvec2> planePointsUnder(
    const std::vector<glm::dvec2>& path, const ViewContext& view, const core::Volume& volume);

/// The voxels of a sketch while the pen is down: those that a commit would find. On the 3D view the
/// engine is asked for what was added to the path, one question at a time.
class SketchedVoxels : public QObject {
    Q_OBJECT

public:
    explicit SketchedVoxels(Workspace& workspace, QObject* parent = nullptr);

    void begin(const ViewContext& view);
    /// @param path all of it, longer than before
    void follow(const std::vector<glm::dvec2>& path);
    /// What is still under way is not told any more.
    void end();
    [[nodiscard]] const std::vector<glm::ivec3>& voxels() const { return m_voxels; }

Q_SIGNALS:
    void grew();

private:
    void add(const std::vector<glm::ivec3>& voxels);
    void askNext();

    Workspace& m_workspace;
    std::optional<ViewContext> m_view;
    std::vector<glm::dvec2> m_path;
    std::size_t m_looked = 0; ///< points of the path that were asked about
    std::vector<glm::ivec3> m_voxels; ///< each once
    bool m_asking = false;
    int m_sketch = 0; ///< number of the present one
};

} // namespace ui
