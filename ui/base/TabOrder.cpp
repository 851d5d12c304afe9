// SPDX-License-Identifier: Apache-2.0
#include "ui/base/TabOrder.h"

#include <QLayout>
#include <QScrollArea>
#include <QSplitter>

namespace ui {

namespace {

/// Puts one widget after another behind where the tab key was last.
class Chain {
public:
    void add(QWidget* widget)
    {
        if ((widget->focusPolicy() & Qt::TabFocus) != 0) {
            if (m_last)
                QWidget::setTabOrder(m_last, widget);
            m_last = widget;
        }
        if (const auto* splitter = qobject_cast<QSplitter*>(widget)) {
            for (int part = 0; part < splitter->count(); ++part)
                add(splitter->widget(part));
        } else if (const auto* area = qobject_cast<QScrollArea*>(widget); area && area->widget()) {
            add(area->widget());
        } else if (widget->layout()) {
            add(*widget->layout());
        }
    }

private:
    void add(const QLayout& layout)
    {
        for (int at = 0; at < layout.count(); ++at) {
            QLayoutItem* item = layout.itemAt(at);
            if (QWidget* widget = item->widget())
                add(widget);
            else if (const QLayout* inner = item->layout())
                add(*inner);
        }
    }

    QWidget* m_last = nullptr;
};

} // namespace

void tabAsLaidOut(QWidget& dialog)
{
    // Where the chain begins is the dialog, which Qt lets be a part of an order only so.
    const Qt::FocusPolicy policy = dialog.focusPolicy();
    dialog.setFocusPolicy(Qt::TabFocus);
    Chain().add(&dialog);
    dialog.setFocusPolicy(policy);
}

} // namespace ui
