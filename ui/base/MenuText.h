// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// A name as an entry of a menu or a button shows it, where an ampersand would mark a letter.
[[nodiscard]] inline QString menuText(const QString& name)
{
    return QString(name).replace(QLatin1Char('&'), QLatin1String("&&"));
}

/// The name that menuText() was made of.
[[nodiscard]] inline QString plainText(const QString& menuText)
{
    return QString(menuText).replace(QLatin1String("&&"), QLatin1String("&"));
}

} // namespace ui
