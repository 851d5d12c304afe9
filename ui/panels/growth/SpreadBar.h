// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/EditableRange.h"
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

/// The part of the growth panel for growing from seeds: the result is previewed in all views until
/// it is applied or cancelled. An edit made meanwhile changes the state before the preview, and the
/// preview is computed again.
class SpreadBar : public QWidget {
    Q_OBJECT

public:
    explicit SpreadBar(Workspace& workspace, QWidget* parent = nullptr);

    /// The edit that the settings describe.
    [[nodiscard]] core::GrowFromSeeds edit() const;
    /// Whether a preview is wanted, shown or being computed.
    [[nodiscard]] bool previewing() const { return m_wanted; }

public Q_SLOTS:
    void preview();
    void apply();
    void cancel();

private:
    void build();
    void begin();
    void beginAgain();
    void follow();
    void stop();
    void showState();
    /// The number of segments that have voxels or seeds to compete with.
    [[nodiscard]] int competitors() const;
    /// The label plane in which they compete.
    [[nodiscard]] std::uint8_t plane() const;

    Workspace& m_workspace;
    FoldButton* m_fold = nullptr; ///< folds the section, which is useless with one segment
    QComboBox* m_extent = nullptr;
    QPushButton* m_preview = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_cancel = nullptr;
    QLabel* m_text = nullptr;
    QTimer m_watch; ///< starts the preview again after another edit
    QTimer m_again; ///< starts it once after several changes of the editable range
    QElapsedTimer m_sinceBegun; ///< for the text
    bool m_wanted = false;
    std::uint8_t m_plane = 0; ///< of the preview that is wanted
    /// The history's position when the preview was last started. It is not started there again by
    /// itself unless something else was open in between.
    std::optional<core::RowId> m_begunAt;
    std::optional<core::EditableRange> m_begunWithin{}; ///< the range of the preview
};

} // namespace ui
