// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/history/History.h"

#include <QLabel>

#include <cstdint>
#include <memory>

namespace ui {

class Workspace;

/// A line that appears after a growth and offers to fill the pinholes that noise has left in a
/// segment: holes of at most mostVoxels voxels, surrounded by the segment on all sides. It is
/// hidden if there are none, and after the next step. Filling is one step of undo. The engine reads
/// the labels and a background thread searches them, so the window does not wait.
class PinholeOffer : public QLabel {
    Q_OBJECT

public:
    /// Voxels of the largest hole that is offered. A larger one may well be another tissue.
    static constexpr std::int64_t mostVoxels = 8;

    explicit PinholeOffer(Workspace& workspace, QWidget* parent = nullptr);

    /// Starts a search for pinholes of a segment; it begins when all waiting work of the session is
    /// done.
    void lookInto(int label);
    /// Hides the line and drops a search.
    void forget();

private:
    struct Look;
    void readOn();
    void search();
    void offer(int label, std::int64_t voxels);
    void follow();
    void fill();

    Workspace& m_workspace;
    std::shared_ptr<Look> m_look; ///< null: nothing is searched or offered
    core::Background m_background; ///< last: its results are delivered to all of the above
};

} // namespace ui
