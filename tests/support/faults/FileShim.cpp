// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FileShim.h"

#include <QDir>
#include <QFile>

namespace test {

namespace {

const QString logName = QStringLiteral("shim.log");

} // namespace

WatchedHome::WatchedHome()
{
    for (const QString& folder : folders()) {
        if (!QDir().mkpath(path(folder))
            || !QFile::setPermissions(
                path(folder), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner))
            qFatal("no folder %s", qPrintable(path(folder)));
    }
}

QStringList WatchedHome::folders()
{
    return {QStringLiteral("cache"), QStringLiteral("config"), QStringLiteral("state"),
        QStringLiteral("data"), QStringLiteral("run"), QStringLiteral("tmp")};
}

QProcessEnvironment WatchedHome::environment(const FileFault& fault) const
{
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    const auto set = [&all](const char* name, const QString& value) {
        all.insert(QLatin1String(name), value);
    };
    set("HOME", m_folder.path());
    set("XDG_CACHE_HOME", path(QStringLiteral("cache")));
    set("XDG_CONFIG_HOME", path(QStringLiteral("config")));
    set("XDG_STATE_HOME", path(QStringLiteral("state")));
    set("XDG_DATA_HOME", path(QStringLiteral("data")));
    set("XDG_RUNTIME_DIR", path(QStringLiteral("run")));
    set("TMPDIR", path(QStringLiteral("tmp")));
    set("LD_PRELOAD", QStringLiteral(BURIN_FILE_SHIM));
    set("BURIN_SHIM_LOG", path(logName));
    // A sanitizer wants to be first, and can do without.
    set("ASAN_OPTIONS",
        qEnvironmentVariable("ASAN_OPTIONS") + QStringLiteral(":verify_asan_link_order=0"));
    if (fault.under.isEmpty())
        return all;
    set("BURIN_SHIM_UNDER", fault.under);
    set("BURIN_SHIM_FAIL", QString::fromLatin1(fault.calls));
    if (!fault.of.isEmpty())
        set("BURIN_SHIM_OF", QString::fromLatin1(fault.of));
    set("BURIN_SHIM_NTH", QString::number(fault.first));
    set("BURIN_SHIM_LAST", QString::number(fault.last));
    set("BURIN_SHIM_ERROR",
        fault.error != 0 ? QString::number(fault.error) : QStringLiteral("short"));
    return all;
}

Outcome WatchedHome::burin(const QStringList& arguments, const FileFault& fault) const
{
    return test::burin(arguments, environment(fault));
}

std::vector<FileEvent> WatchedHome::events() const
{
    std::vector<FileEvent> all;
    QFile log(path(logName));
    if (!log.open(QIODevice::ReadOnly))
        return all;
    for (const QByteArray& line : log.readAll().split('\n')) {
        const QByteArrayList words = line.split('\t');
        if (words.size() >= 3)
            all.push_back({.what = words[0],
                .path = QDir::cleanPath(QFile::decodeName(words[1])),
                .more = QFile::decodeName(words[2])});
    }
    log.remove();
    return all;
}

} // namespace test
