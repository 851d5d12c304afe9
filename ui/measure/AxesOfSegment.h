// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "ui/geometry/ViewContext.h"

#include <QObject>

#include <cstdint>
#include <memory>

namespace ui {

class Workspace;

/// Suggests the longest axis of a segment in a slice and the longest one across it
/// (core/outline/SegmentAxes.h), as two measurements: each is a step that undo takes back. The
/// engine reads the labels, another thread finds the axes.
class AxesOfSegment : public QObject {
    Q_OBJECT

public:
    explicit AxesOfSegment(Workspace& workspace, QObject* parent = nullptr);

    /// Of what hangs together at a place of the view's slice, of the segment there: where several
    /// overlap, that in the label plane of the active one, else that of the highest plane. What was
    /// asked before is dropped.
    /// @param view a slice
    void suggest(const ViewContext& view, const glm::dvec3& placeLps);
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void read(const std::shared_ptr<Job>& job);
    void find(const std::shared_ptr<Job>& job);
    void keep(const Job& job);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< null: nothing was asked
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
