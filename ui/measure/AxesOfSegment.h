// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "ui/geometry/ViewContext.h"

#include <QObject>

#include <cstdint>
#include <memory>

namespace ui {

class Workspace;

/// Measures the longest axis of a segment in a slice and the longest axis perpendicular to it
/// (core/outline/SegmentAxes.h). Both become distance measurements; each is a step that can be
/// undone. The engine reads the labels and a background thread finds the axes. GUI thread.
class AxesOfSegment : public QObject {
    Q_OBJECT

public:
    explicit AxesOfSegment(Workspace& workspace, QObject* parent = nullptr);

    /// Starts a measurement of the connected part of a segment, within the view's slice, at a
    /// place. If several segments overlap there, shown ones come before hidden ones; among these
    /// the one in the active segment's label plane comes first, then those in higher planes. A
    /// measurement that is still being computed is dropped.
    /// @param view shows a slice
    void suggest(const ViewContext& view, const glm::dvec3& placeLps);
    /// Drops the measurement that is being computed.
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void read(const std::shared_ptr<Job>& job);
    void find(const std::shared_ptr<Job>& job);
    void keep(const Job& job);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< null: nothing is being computed
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
