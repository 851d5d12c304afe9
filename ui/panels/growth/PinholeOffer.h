// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/history/History.h"

#include <QLabel>

#include <cstdint>
#include <memory>

namespace ui {

class Workspace;

/// After a growth: a line that offers to fill the pinholes that noise has left in a segment, which
/// are holes of a few voxels that it surrounds on all sides. Without any the line is hidden, and so
/// it is after the next step. Filling them is one step of undo. The labels are read by the engine
/// and looked through on another thread, so that the window does not wait.
class PinholeOffer : public QLabel {
    Q_OBJECT

public:
    /// The largest hole that is offered to be filled; what is larger may well be another tissue.
    static constexpr std::int64_t mostVoxels = 8;

    explicit PinholeOffer(Workspace& workspace, QWidget* parent = nullptr);

    /// Looks for pinholes of a segment when everything that waits is done.
    void lookInto(int label);
    /// Hides the line, and drops what is being looked for.
    void forget();

private:
    struct Look;
    void readOn();
    void search();
    void offer(int label, std::int64_t voxels);
    void follow();
    void fill();

    Workspace& m_workspace;
    std::shared_ptr<Look> m_look; ///< null: nothing is looked for or offered
    core::Background m_background; ///< last: its results are delivered to all of the above
};

} // namespace ui
