// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/PacsSources.h"

#include <QHash>
#include <QJsonDocument>
#include <QSettings>

namespace ui {

namespace {

const QString sourcesKey = QStringLiteral("pacs/sources");

/// By the address they are for.
QHash<QString, core::WebLogin>& logins()
{
    static QHash<QString, core::WebLogin> known;
    return known;
}

} // namespace

std::vector<core::PacsSource> pacsSources()
{
    const QByteArray text = QSettings().value(sourcesKey).toByteArray();
    std::vector<core::PacsSource> sources =
        core::sourcesFromJson(QJsonDocument::fromJson(text).array());
    for (core::PacsSource& source : sources) {
        if (auto* web = std::get_if<core::WebNode>(&source.node))
            web->login = logins().value(source.name + u' ' + web->name());
    }
    return sources;
}

void setPacsSources(const std::vector<core::PacsSource>& sources)
{
    logins().clear();
    for (const core::PacsSource& source : sources) {
        const auto* web = std::get_if<core::WebNode>(&source.node);
        if (web && web->login.isGiven())
            logins().insert(source.name + u' ' + web->name(), web->login);
    }
    QSettings().setValue(
        sourcesKey, QJsonDocument(core::toJson(sources)).toJson(QJsonDocument::Compact));
}

} // namespace ui
