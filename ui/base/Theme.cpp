// SPDX-License-Identifier: Apache-2.0
#include "ui/base/Theme.h"

#include "ui/base/Icons.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QProxyStyle>
#include <QWidget>

#include <utility>

namespace ui::theme {

namespace {

QString bestFamily()
{
    for (const QString& name : {QStringLiteral("Inter"), QStringLiteral("Inter Variable")}) {
        if (QFontDatabase::hasFamily(name))
            return name;
    }
    return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
}

QString family()
{
    // Views ask with every picture, and the system looks through all its fonts for an answer.
    static const QString best = bestFamily();
    return best;
}

QFont font(double pixels, QFont::Weight weight)
{
    QFont result(family());
    // Fractional pixel sizes exist only through points; 96 logical dots per inch make 0.75.
    result.setPointSizeF(pixels * 0.75);
    result.setWeight(weight);
    result.setHintingPreference(QFont::PreferVerticalHinting);
    return result;
}

QPalette palette()
{
    QPalette result;
    result.setColor(QPalette::Window, panel);
    result.setColor(QPalette::WindowText, text);
    result.setColor(QPalette::Base, window);
    result.setColor(QPalette::AlternateBase, panel);
    result.setColor(QPalette::Text, text);
    result.setColor(QPalette::PlaceholderText, secondary);
    result.setColor(QPalette::Button, raised);
    result.setColor(QPalette::ButtonText, text);
    result.setColor(QPalette::BrightText, bad);
    result.setColor(QPalette::Highlight, accent);
    result.setColor(QPalette::HighlightedText, window);
    result.setColor(QPalette::Link, accent);
    result.setColor(QPalette::ToolTipBase, raised);
    result.setColor(QPalette::ToolTipText, text);
    result.setColor(QPalette::Light, line);
    result.setColor(QPalette::Midlight, line);
    result.setColor(QPalette::Mid, line);
    result.setColor(QPalette::Dark, window);
    result.setColor(QPalette::Shadow, Qt::black);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        result.setColor(QPalette::Disabled, role, faint);
    return result;
}

/// Fusion without what is noise here: pictures in dialog buttons, underlined menu letters;
/// questions and warnings bear icons of the family.
class PlainStyle : public QProxyStyle {
public:
    PlainStyle()
        : QProxyStyle(QStringLiteral("Fusion"))
    {
    }
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
        QStyleHintReturn* data) const override
    {
        if (hint == SH_DialogButtonBox_ButtonsHaveIcons || hint == SH_UnderlineShortcut)
            return 0;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
    QIcon standardIcon(
        StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override
    {
        const double ratio = widget != nullptr ? widget->devicePixelRatioF() : 1.0;
        switch (which) {
        case SP_MessageBoxQuestion:
            return tintedIcon(QStringLiteral("question"), accent, 32, ratio);
        case SP_MessageBoxInformation:
            return tintedIcon(QStringLiteral("caution"), accent, 32, ratio);
        case SP_MessageBoxWarning:
            return tintedIcon(QStringLiteral("caution"), caution, 32, ratio);
        case SP_MessageBoxCritical:
            return tintedIcon(QStringLiteral("caution"), bad, 32, ratio);
        default:
            return QProxyStyle::standardIcon(which, option, widget);
        }
    }
};

QString styleSheet()
{
    QFile file(QStringLiteral(":/burin/style/burin.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QColor> names[] = {{"@window", window}, {"@panel", panel},
        {"@raised", raised}, {"@line", line}, {"@text", text}, {"@secondary", secondary},
        {"@faint", faint}, {"@accent", accent}, {"@selected", selected}, {"@good", good},
        {"@caution", caution}, {"@bad", bad}};
    for (const auto& [name, colour] : names)
        sheet.replace(QLatin1String(name), colour.name());
    return sheet;
}

} // namespace

QFont bodyFont()
{
    return font(13.0, QFont::Normal);
}

QFont headingFont()
{
    return font(12.5, QFont::DemiBold);
}

QFont smallFont()
{
    return font(11.5, QFont::Normal);
}

void apply(QApplication& application)
{
    registerResources();
    QApplication::setStyle(new PlainStyle);
    QApplication::setPalette(palette());
    QApplication::setFont(bodyFont());
    application.setStyleSheet(styleSheet());
}

} // namespace ui::theme
