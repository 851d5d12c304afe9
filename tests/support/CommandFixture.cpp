// SPDX-License-Identifier: Apache-2.0
#include "tests/support/CommandFixture.h"

#include "core/edits/EditJson.h"
#include "core/nifti/NiftiWriter.h"
#include "tests/support/SmallStudy.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace test {

bool writeStudy(const QString& path, const core::LoadedVolume& study)
{
    std::vector<std::int16_t> values;
    values.reserve(study.codes.size());
    for (const std::uint16_t code : study.codes)
        values.push_back(std::int16_t(code - 1024));
    return core::writeNifti(path,
        {.geometry = study.volume.geometry,
            .voxels = std::span<const std::int16_t>(values),
            .description = {}})
        .has_value();
}

QString key(const char* name)
{
    return QLatin1String(name);
}

QJsonObject goTo(int seq)
{
    return {{key("edit"), key("goTo")}, {key("seq"), seq}};
}

QJsonArray toJson(const std::vector<core::Edit>& edits)
{
    QJsonArray list;
    for (const core::Edit& edit : edits)
        list.append(core::editToJson(edit));
    return list;
}

bool CommandFixture::prepareStudy()
{
    m_study = otherStudy("small.nii.gz", smallStudy());
    return !m_study.isEmpty();
}

QString CommandFixture::otherStudy(const char* name, const core::LoadedVolume& study) const
{
    const QString file = m_studies.filePath(QLatin1String(name));
    return writeStudy(file, study) ? file : QString();
}

QString CommandFixture::path(const char* name) const
{
    return m_folder->filePath(QLatin1String(name));
}

QString CommandFixture::recipe(const char* name, const QJsonObject& content) const
{
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly))
        qFatal("cannot write %s", name);
    file.write(QJsonDocument(content).toJson());
    return file.fileName();
}

Outcome CommandFixture::run(
    const QString& recipeFile, const char* session, const QStringList& more) const
{
    return burin(QStringList{QStringLiteral("run"), recipeFile, QStringLiteral("--study"), m_study,
                     QStringLiteral("--session"), path(session)}
        + more);
}

QString CommandFixture::recipeOf(const char* session, const char* name) const
{
    const Outcome written =
        burin({QStringLiteral("history"), path(session), QStringLiteral("--as-recipe")});
    return recipe(name, QJsonDocument::fromJson(written.output).object());
}

QJsonObject CommandFixture::history(const char* session) const
{
    const Outcome outcome =
        burin({QStringLiteral("history"), path(session), QStringLiteral("--json")});
    return QJsonDocument::fromJson(outcome.output).object();
}

QString CommandFixture::lastHash(const char* session) const
{
    const QJsonArray commands = history(session).value(key("commands")).toArray();
    return commands.last().toObject().value(key("hashAfter")).toString();
}

} // namespace test
