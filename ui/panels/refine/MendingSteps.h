// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/MendingStrip.h"

#include <QObject>

namespace ui {

class ComparePanel;
class Workspace;

/// Tells which steps of mending an imported mask are done, and shows them in a strip: it is shown
/// while an imported mask is among the steps that led to the present state, unless the user has
/// closed it, which the program remembers. Pictures do not move under the pen: it neither comes nor
/// goes while a stroke is open, unless its own cross is pressed.
///
/// A step is done: to look, when the active segment was searched for places to look at; to mend,
/// when voxels of segments were edited after the import, or when all places are ticked (there may
/// be none); to compare, when there is a comparison with what was imported; to export, when that
/// was done since the last edit.
class MendingSteps : public QObject {
    Q_OBJECT

public:
    using Step = MendingStrip::Step;

    MendingSteps(Workspace& workspace, ComparePanel& panel, MendingStrip& strip);

    [[nodiscard]] bool isDone(Step step) const { return m_done[std::size_t(step)]; }
    /// The first that is not done; none: all are.
    [[nodiscard]] std::optional<Step> next() const;
    /// Whether the strip is shown when there is a mask to be mended.
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    void setWanted(bool wanted);
    /// Whether there is a mask that was imported.
    [[nodiscard]] bool hasMask() const { return m_hasMask; }
    void noteExported();

Q_SIGNALS:
    void changed(); ///< isWanted() or hasMask()

private:
    [[nodiscard]] bool isMended() const;
    void update();

    Workspace& m_workspace;
    ComparePanel& m_panel;
    MendingStrip& m_strip;
    std::array<bool, MendingStrip::steps> m_done{};
    bool m_wanted = true;
    bool m_hasMask = false;
    bool m_exported = false;
};

} // namespace ui
