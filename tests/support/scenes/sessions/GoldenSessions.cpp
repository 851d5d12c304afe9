// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/sessions/GoldenSessions.h"

#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <algorithm>
#include <cmath>

namespace test {

core::LoadedVolume goldenStudy()
{
    core::LoadedVolume loaded = smallStudy();
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    const glm::dvec3 middle = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    std::size_t at = 0;
    for (int k = 0; k < geometry.size.z; ++k) {
        for (int j = 0; j < geometry.size.y; ++j) {
            for (int i = 0; i < geometry.size.x; ++i, ++at) {
                const glm::dvec3 place =
                    geometry.toWorld({i, j, k}) - middle - glm::dvec3(0.0, 0.0, 20.0);
                const double toBall = std::min(glm::length(place - glm::dvec3(-10.0, 0.0, 0.0)),
                    glm::length(place - glm::dvec3(10.0, 0.0, 0.0)));
                const bool inTube = std::abs(place.x) < 10.0 && std::hypot(place.y, place.z) < 1.3;
                if (toBall < 4.0 || inTube)
                    loaded.codes[at] = std::uint16_t(300 + 1024);
            }
        }
    }
    return loaded;
}

QString goldenFolder()
{
    return QStringLiteral(BURIN_TEST_DATA_DIR "/gold");
}

QStringList goldenNames()
{
    QStringList names;
    for (const QString& file :
        QDir(goldenFolder()).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        names += file.chopped(5);
    return names;
}

QString rowsOf(const QString& sessionFile)
{
    QString text;
    const QString connection = QStringLiteral("golden rows");
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection);
        database.setDatabaseName(sessionFile);
        database.setConnectOptions(QStringLiteral("QSQLITE_OPEN_READONLY"));
        QSqlQuery query(database);
        if (!database.open()
            || !query.exec(QStringLiteral("SELECT id, parent, growthGeneration, stateHash, "
                                          "deltaSha256, name, edit FROM row ORDER BY id")))
            qFatal("cannot read %s", qUtf8Printable(sessionFile));
        while (query.next()) {
            QStringList columns;
            for (int column = 0; column < 7; ++column)
                columns += query.value(column).toString();
            text += columns.join(QLatin1String(" | ")) + u'\n';
        }
    }
    QSqlDatabase::removeDatabase(connection);
    return text;
}

QString differenceFromGold(const QString& name, const QString& text)
{
    QFile file(QDir(goldenFolder()).filePath(name));
    if (qEnvironmentVariableIsSet("BURIN_RECORD_GOLD")) {
        if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0)
            qFatal("cannot write %s", qUtf8Printable(file.fileName()));
        return {};
    }
    if (!file.open(QIODevice::ReadOnly))
        return QStringLiteral("no %1").arg(file.fileName());
    const QStringList expected = QString::fromUtf8(file.readAll()).split(u'\n');
    const QStringList actual = text.split(u'\n');
    for (qsizetype i = 0; i < std::max(expected.size(), actual.size()); ++i) {
        if (expected.value(i) != actual.value(i))
            return QStringLiteral("%1, line %2:\n%3\nwas expected:\n%4")
                .arg(name)
                .arg(i + 1)
                .arg(actual.value(i), expected.value(i));
    }
    return {};
}

} // namespace test
