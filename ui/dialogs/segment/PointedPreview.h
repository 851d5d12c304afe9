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

/// Previews in a PreviewRow what a button would do, while the pointer rests on it or it has the
/// keyboard focus; the fields beside a button count as that button. A click on it does not wait for
/// the preview. While there is a preview, Esc and the keys of undo take it back instead of a step
/// of the history, unless they are typed into a field of text.
class PointedPreview : public QObject {
    Q_OBJECT

public:
    /// What would be carried out; none: nothing can be done.
    using Asked = std::function<std::optional<core::Edit>()>;

    /// @param row must outlive this
    explicit PointedPreview(PreviewRow& row);

    /// From now on previews @p asked while @p widget is pointed at. Both live as long as this.
    void watch(QWidget& widget, Asked asked);
    /// Previews what the entry of a menu would do that the pointer or the keyboard has come to;
    /// none: there is no such entry.
    void pointAtEntry(const std::optional<core::Edit>& edit);
    /// To be called when a button may stand for another edit than before.
    void follow();
    /// To be called when what is pointed at was carried out: nothing is previewed until the pointer
    /// or the keyboard comes to something else.
    void rest();
    /// Ends rest() and follows, because what is pointed at stands for something else now.
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
    QWidget* m_pointedAt = nullptr; ///< the watched widget under the pointer
    QWidget* m_focused = nullptr; ///< the watched widget with the keyboard focus
    std::optional<core::Edit> m_entry; ///< of a menu; it takes precedence over both
    bool m_rests = false; ///< rest() was called
};

} // namespace ui
