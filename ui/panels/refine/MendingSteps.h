// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/MendingStrip.h"

#include <QObject>

namespace ui {

class ComparePanel;
class Workspace;

/// Finds out which steps of mending an imported mask are done, and shows them in a strip. The strip
/// is shown while an import of a mask is among the steps that led to the present state, unless the
/// user has closed it; that choice is saved. While a stroke is open the strip neither appears nor
/// disappears, since that would move the views under the pen; only its own close button takes
/// effect at once.
///
/// When a step counts as done:
/// - Look: the active segment was searched for places to look at.
/// - Mend: labels were edited after the last import, or all places are ticked (there may be none).
/// - Compare: there is a comparison with what was imported.
/// - Export: segments were exported since the last change of labels.
class MendingSteps : public QObject {
    Q_OBJECT

public:
    using Step = MendingStrip::Step;

    MendingSteps(Workspace& workspace, ComparePanel& panel, MendingStrip& strip);

    [[nodiscard]] bool isDone(Step step) const { return m_done[std::size_t(step)]; }
    /// The step that was begun in the strip, until it is done; then the one after the last that is
    /// done, and in the end those that were left out. None: all are done.
    [[nodiscard]] std::optional<Step> next() const;
    /// Whether the user wants the strip; it is then shown whenever there is an imported mask.
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    void setWanted(bool wanted);
    /// Whether the present state contains an imported mask.
    [[nodiscard]] bool hasMask() const { return m_hasMask; }
    /// To be called after each export of segments.
    void noteExported();

Q_SIGNALS:
    void changed(); ///< isWanted() or hasMask() has changed

private:
    [[nodiscard]] bool isMended() const;
    void update();

    Workspace& m_workspace;
    ComparePanel& m_panel;
    MendingStrip& m_strip;
    std::array<bool, MendingStrip::steps> m_done{};
    std::optional<Step> m_begun; ///< the step that was last asked for in the strip
    bool m_wanted = true;
    bool m_hasMask = false;
    bool m_exported = false;
};

} // namespace ui
