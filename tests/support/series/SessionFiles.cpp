// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/SessionFiles.h"

#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/dcmdata/dctk.h>

#include <QCryptographicHash>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <array>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

using namespace core;

QByteArray makeSession(const QString& path, std::function<RowOrigin()> origin)
{
    reference::ReferenceEngine engine;
    const auto session = *EditSession::create(engine, smallStudy(), {.file = path});
    if (origin)
        session->setOrigin(std::move(origin));
    for (const Edit& edit : manyEdits()) {
        static_cast<void>(session->apply(edit));
        static_cast<void>(session->settle());
    }
    static_cast<void>(session->goTo(4));
    static_cast<void>(session->apply(drillAt(1)));
    static_cast<void>(session->apply(growBrain(1)));
    static_cast<void>(session->undo());
    session->display().setSegmentVisible(2, false);
    static_cast<void>(session->settle());
    return session->stateHash();
}

void writeSmallSeries(
    const QString& folder, const char* seriesUid, int shift, const char* description)
{
    const LoadedVolume small = smallStudy();
    const VolumeGeometry& geometry = small.volume.geometry;
    SyntheticSeries series;
    series.size = geometry.size;
    series.spacing = {1.0, 1.0};
    series.origin = geometry.toWorld(glm::dvec3(0.0));
    series.step = geometry.toWorld(glm::dvec3(0.0, 0.0, 1.0)) - series.origin;
    series.seriesUid = QLatin1String(seriesUid);
    series.stored = [&](const glm::ivec3& index) {
        const int offset = index.x + geometry.size.x * (index.y + geometry.size.y * index.z);
        return int(small.codes[std::size_t(offset)]) + shift;
    };
    series.adjust = [description](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SeriesDescription, description);
    };
    writeSeries(series, folder);
}

namespace {

bool withDatabase(const QString& path, const std::function<bool(QSqlQuery&)>& work)
{
    bool good = false;
    {
        QSqlDatabase database =
            QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("test"));
        database.setDatabaseName(path);
        good = database.open();
        QSqlQuery query(database);
        good = good && work(query);
    }
    QSqlDatabase::removeDatabase(QStringLiteral("test"));
    return good;
}

} // namespace

bool runSql(const QString& path, const QString& sql)
{
    return withDatabase(
        path, [&](QSqlQuery& query) { return query.exec(sql) && query.numRowsAffected() > 0; });
}

QString text(const QString& path, const QString& sql)
{
    QString value;
    withDatabase(path, [&](QSqlQuery& query) {
        const bool found = query.exec(sql) && query.next();
        value = found ? query.value(0).toString() : QString();
        return found;
    });
    return value;
}

QByteArray fingerprint(const QString& path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return hash.result().toHex();
}

Unprivileged::Unprivileged()
    : m_wasRoot(::geteuid() == 0)
{
    constexpr uid_t nobody = 65534;
    if (m_wasRoot && ::setresuid(nobody, nobody, 0) != 0)
        qFatal("root cannot become nobody");
}

Unprivileged::~Unprivileged()
{
    if (m_wasRoot && ::setresuid(0, 0, 0) != 0)
        qFatal("nobody cannot become root");
}

OtherWindow::OtherWindow(const QString& path)
{
    const QByteArray name = QFile::encodeName(path);
    std::array<int, 2> ready{};
    if (::pipe(ready.data()) != 0)
        qFatal("no pipe");
    m_process = ::fork();
    if (m_process == 0) {
        // Only what may be called between fork() and exec().
        struct flock lock { };
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        lock.l_start = 0x40000000; // the bytes that SQLite locks
        lock.l_len = 512;
        const int file = ::open(name.constData(), O_RDWR | O_CLOEXEC);
        const bool locked = file >= 0 && ::fcntl(file, F_SETLK, &lock) == 0;
        static_cast<void>(::write(ready[1], locked ? "y" : "n", 1) == 1);
        while (true)
            ::pause();
    }
    char answer = 'n';
    const bool answered = ::read(ready[0], &answer, 1) == 1;
    ::close(ready[0]);
    ::close(ready[1]);
    if (!answered || answer != 'y')
        qFatal("%s cannot be locked", name.constData());
}

OtherWindow::~OtherWindow()
{
    ::kill(m_process, SIGKILL);
    ::waitpid(m_process, nullptr, 0);
}

} // namespace test
