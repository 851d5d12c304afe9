// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class FoldButton;
class Workspace;

/// Growing from seeds, a part of the growth panel: what comes of it is shown in all views until it
/// is applied or cancelled. Whatever is done meanwhile is done to what was there before, and the
/// preview follows.
class SpreadBar : public QWidget {
    Q_OBJECT

public:
    explicit SpreadBar(Workspace& workspace, QWidget* parent = nullptr);

    /// The edit that the settings stand for.
    [[nodiscard]] core::GrowFromSeeds edit() const;
    /// Whether a preview is asked for, shown or being worked out.
    [[nodiscard]] bool previewing() const { return m_wanted; }

public Q_SLOTS:
    void preview();
    void apply();
    void cancel();

private:
    void build();
    void begin();
    void follow();
    void stop();
    void showState();
    /// How many segments have voxels or seeds to compete with.
    [[nodiscard]] int competitors() const;

    Workspace& m_workspace;
    FoldButton* m_fold = nullptr; ///< this takes room that one segment has no use for
    QComboBox* m_extent = nullptr;
    QPushButton* m_preview = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_cancel = nullptr;
    QLabel* m_text = nullptr;
    QTimer m_watch; ///< begins a preview anew after something else was done
    QElapsedTimer m_sinceBegun; ///< for the text
    bool m_wanted = false;
    /// Where the history stood when the preview was begun last; it is not begun there again by
    /// itself unless something else was open since.
    std::optional<core::RowId> m_begunAt;
};

} // namespace ui
