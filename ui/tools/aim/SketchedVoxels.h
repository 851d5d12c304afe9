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

/// Removes duplicates; the voxels stay in the order of their first occurrence.
[[nodiscard]] std::vector<glm::ivec3> uniqueVoxels(const std::vector<glm::ivec3>& voxels);

/// The distance, in pixels, between neighbouring points of a sketch: at most half a voxel, so that
/// no voxel is skipped.
[[nodiscard]] double sketchStepPixels(const core::Volume& volume, const ViewContext& view);

/// A path that is sketched in a view, in logical pixels.
struct SketchPath {
    std::vector<glm::dvec2> points{};
    /// Half of its width at each point, interpolated linearly between them; empty: it is a line.
    std::vector<double> radii{};

    void clear();
};

/// The voxels under a path on a slice, each once, without those outside the volume.
[[nodiscard]] std::vector<glm::ivec3> voxelsUnder(
    const SketchPath& path, const ViewContext& slice, const core::Volume& volume);

/// The points of the view plane under a path on the 3D view, as askWhatIsSeen() takes them.
[[nodiscard]] std::vector<glm::dvec2> planePointsUnder(
    const SketchPath& path, const ViewContext& view, const core::Volume& volume);

/// The voxels of a sketch while the pen is down: the same that a commit would find. For the 3D view
/// the engine is asked about the new part of the path, one question at a time.
class SketchedVoxels : public QObject {
    Q_OBJECT

public:
    explicit SketchedVoxels(Workspace& workspace, QObject* parent = nullptr);

    void begin(const ViewContext& view);
    /// @param path the whole path, longer than before
    void follow(const SketchPath& path);
    /// Ends the sketch; answers that are still under way are dropped.
    void end();
    [[nodiscard]] const std::vector<glm::ivec3>& voxels() const { return m_voxels; }
    /// Whether voxels() covers the whole path so far.
    [[nodiscard]] bool isComplete() const { return !m_asking && m_looked >= m_path.points.size(); }

Q_SIGNALS:
    void grew();

private:
    void add(const std::vector<glm::ivec3>& voxels);
    void askNext();

    Workspace& m_workspace;
    std::optional<ViewContext> m_view;
    SketchPath m_path;
    std::size_t m_looked = 0; ///< number of path points that were asked about
    std::vector<glm::ivec3> m_voxels; ///< each once
    bool m_asking = false;
    int m_sketch = 0; ///< number of the present sketch
};

} // namespace ui
