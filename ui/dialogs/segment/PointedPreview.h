// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <QObject>

#include <functional>
#include <map>
#include <optional>

class QWidget;

namespace ui {

class PreviewRow;

/// Previews in a PreviewRow what a button would do, while the pointer rests on it or the keyboard
/// has come to it; fields of a button count as that button. A click does it at once, whether its
/// preview is there or not. Esc and the keys of undo take back what is previewed, and no step,
/// unless a field of text has them.
class PointedPreview : public QObject {
    Q_OBJECT

public:
    /// What would be carried out; none: nothing can be done.
    using Asked = std::function<std::optional<core::Edit>()>;

    /// @param row must live as long
    explicit PointedPreview(PreviewRow& row);

    /// From now on previews @p asked while @p widget is pointed at. Both live as long as this.
    void watch(QWidget& widget, Asked asked);
    /// The same for what an entry of a menu would do that is pointed at, or has the keyboard; none:
    /// there is no such entry.
    void pointAtEntry(const std::optional<core::Edit>& edit);
    /// What would be carried out may be another edit now.
    void follow();
    /// What is pointed at was done: nothing more is previewed until something else is pointed at.
    void rest();
    /// As if what is pointed at were pointed at anew, because it is about something else now.
    void pointAnew();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setPointedAt(QWidget* widget);
    void setFocused(QWidget* widget);
    void hearKeys();
    void look(QWidget& widget, const QEvent& event);
    [[nodiscard]] bool isPenElsewhere(QObject& receiver, const QEvent& event) const;
    [[nodiscard]] bool takesBack(QObject& receiver, QEvent& event);

    PreviewRow& m_row;
    std::map<QObject*, Asked> m_watched;
    QWidget* m_pointedAt = nullptr; ///< by the pointer
    QWidget* m_focused = nullptr; ///< by the keyboard
    std::optional<core::Edit> m_entry; ///< of a menu, which goes before both
    bool m_rests = false;
};

} // namespace ui
