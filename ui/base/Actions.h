// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QMenu;
class QWidget;

namespace ui {

/// Everything the window can be told to do, by name: text, keys, tip, and when it is possible.
/// Menus and buttons show these actions; nobody else makes any.
class Actions : public QObject {
    Q_OBJECT

public:
    struct Entry {
        QString id; ///< "edit.undo"
        QString text;
        QList<QKeySequence> keys{};
        QString icon{}; ///< resources/icons; may be empty
        QString tip{}; ///< may be empty
        std::function<void()> run;
        std::function<bool()> possible{}; ///< asked by refresh(); none: always
        std::function<bool()> checked{}; ///< makes it checkable; asked by refresh()
        std::function<QString()> currentText{}; ///< replaces `text` on refresh(); none: fixed
    };

    /// Keys work anywhere in @p window.
    explicit Actions(QWidget& window);

    QAction& add(Entry entry);
    [[nodiscard]] QAction& operator[](const QString& id) const;
    /// In the order they were added.
    [[nodiscard]] std::vector<QAction*> all() const;
    /// A menu of these actions in this order; an empty name is a separator.
    void fill(QMenu& menu, const QStringList& ids) const;
    /// Asks every action again whether it is possible, checked, and how it is called now.
    void refresh();

private:
    QWidget& m_window;
    std::vector<Entry> m_entries;
    QHash<QString, QAction*> m_actions;
};

} // namespace ui
