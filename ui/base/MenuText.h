// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// Returns a name with each ampersand doubled. A single ampersand in the text of a menu entry or
/// button would mark the next letter as its keyboard shortcut.
[[nodiscard]] inline QString menuText(const QString& name)
{
    return QString(name).replace(QLatin1Char('&'), QLatin1String("&&"));
}

/// Returns the name from which menuText() made @p menuText.
[[nodiscard]] inline QString plainText(const QString& menuText)
{
    return QString(menuText).replace(QLatin1String("&&"), QLatin1String("&"));
}

} // namespace ui
