// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace ui {

/// Where something is to be written: a line for the path, and a button that asks for one. The
/// folder of the last time is where the next one begins.
class TargetRow : public QWidget {
    Q_OBJECT

public:
    /// @param name of the line, as an object @param folderKey of the settings
    /// @param folder where nothing is remembered yet
    TargetRow(const QString& label, const QString& name, const QString& folderKey,
        const QString& folder, QWidget* parent = nullptr);

    /// What the button's dialog says and offers. An answer may name a file that is there.
    void askFor(const QString& title, const QString& filter);
    /// Without blanks at its ends; empty: none is named.
    [[nodiscard]] QString path() const;
    void setPath(const QString& path);
    /// Another name in the same folder, at first in the one that is remembered.
    void setName(const QString& name);
    /// For the next time.
    void remember() const;

Q_SIGNALS:
    void changed();

private:
    void browse();

    QString m_folderKey;
    QString m_folder;
    QString m_title;
    QString m_filter;
    QLineEdit* m_path;
    QPushButton* m_browse;
};

} // namespace ui
