// SPDX-License-Identifier: Apache-2.0
#include "core/sources/PacsSource.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/settings/PacsSources.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace pacsSourceTest {

namespace {

core::PacsSource archive()
{
    core::PacsSource source = core::PacsSource::parse(QStringLiteral("PACS@10.0.0.7:104")).value();
    source.name = QStringLiteral("Archive");
    source.movePort = 11112;
    auto& node = std::get<core::PacsNode>(source.node);
    node.ownAeTitle = QStringLiteral("READER");
    node.tls.authorityFile = QStringLiteral("/keys/ca.pem");
    node.timeoutSeconds = 7;
    return source;
}

core::PacsSource cloud()
{
    core::PacsSource source =
        core::PacsSource::parse(QStringLiteral("https://pacs.example/dicom-web")).value();
    source.name = QStringLiteral("Cloud");
    auto& node = std::get<core::WebNode>(source.node);
    node.login = {
        .user = QStringLiteral("jane"), .password = QStringLiteral("secret"), .token = {}};
    node.loginFile = QStringLiteral("/keys/login");
    node.authorityFile = QStringLiteral("/keys/web.pem");
    return source;
}

} // namespace

/// Named sources: kept as they are, but for passwords.
class PacsSourceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void bothKindsAreKept();
    void settingsKeepNoPassword();
    void nonsenseIsLeftOut();
    void namesAreNoAddresses();
    void halfOfTlsIsRefused_data();
    void halfOfTlsIsRefused();
};

void PacsSourceTest::bothKindsAreKept()
{
    const auto kept = core::sourcesFromJson(core::toJson({archive(), cloud()}));
    QCOMPARE(kept.size(), std::size_t(2));
    const auto& node = std::get<core::PacsNode>(kept[0].node);
    QCOMPARE(kept[0].name, QStringLiteral("Archive"));
    QCOMPARE(kept[0].address(), QStringLiteral("PACS@10.0.0.7:104"));
    QCOMPARE(kept[0].movePort, std::optional<int>(11112));
    QCOMPARE(node.ownAeTitle, QStringLiteral("READER"));
    QCOMPARE(node.tls.authorityFile, QStringLiteral("/keys/ca.pem"));
    QCOMPARE(node.timeoutSeconds, 7);
    const auto& web = std::get<core::WebNode>(kept[1].node);
    QCOMPARE(kept[1].address(), QStringLiteral("https://pacs.example/dicom-web"));
    QVERIFY(!kept[1].movePort);
    QCOMPARE(web.loginFile, QStringLiteral("/keys/login"));
    QCOMPARE(web.authorityFile, QStringLiteral("/keys/web.pem"));
    QVERIFY(!web.login.isGiven());
    QVERIFY(core::findSource(kept, QStringLiteral("archive")) == &kept[0]);
    QVERIFY(core::findSource(kept, QStringLiteral("attic")) == nullptr);
}

void PacsSourceTest::settingsKeepNoPassword()
{
    const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName(QStringLiteral("burin-test"));
    ui::setPacsSources({archive(), cloud()});
    // While the program runs it is known.
    const auto kept = ui::pacsSources();
    QCOMPARE(kept.size(), std::size_t(2));
    QCOMPARE(std::get<core::WebNode>(kept[1].node).login.password, QStringLiteral("secret"));
    QSettings().sync();
    QFile file(QSettings().fileName());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("pacs.example"));
    QVERIFY(!text.contains("secret"));
    QVERIFY(!text.contains("jane"));
    QVERIFY(!text.contains(cloud().address().toUtf8() + "secret"));
}

void PacsSourceTest::nonsenseIsLeftOut()
{
    const QByteArray json = R"([1, {}, {"name": "a"}, {"name": "b", "url": "ftp://x"},
        {"name": "c", "title": "C", "host": "h", "port": 0},
        {"name": "", "title": "C", "host": "h", "port": 104},
        {"name": "d", "title": "D", "host": "h", "port": 104}])";
    const auto kept = core::sourcesFromJson(QJsonDocument::fromJson(json).array());
    QCOMPARE(kept.size(), std::size_t(1));
    QCOMPARE(kept[0].address(), QStringLiteral("D@h:104"));
}

void PacsSourceTest::namesAreNoAddresses()
{
    core::PacsSource source = archive();
    QVERIFY(source.check().has_value());
    source.name = QStringLiteral("A@b:104");
    QVERIFY(!source.check().has_value());
    source.name = QStringLiteral("https://x");
    QVERIFY(!source.check().has_value());
}

void PacsSourceTest::halfOfTlsIsRefused_data()
{
    QTest::addColumn<QString>("authority");
    QTest::addColumn<QString>("certificate");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("missing");
    const QString file = QStringLiteral("/keys/a.pem");
    const QString none;
    QTest::newRow("nothing") << none << none << none << none;
    QTest::newRow("an authority") << file << none << none << none;
    QTest::newRow("everything") << file << file << file << none;
    QTest::newRow("no authority") << none << file << file << QStringLiteral("authority");
    QTest::newRow("a certificate alone") << none << file << none << QStringLiteral("authority");
    QTest::newRow("a key alone") << none << none << file << QStringLiteral("authority");
    QTest::newRow("no key") << file << file << none << QStringLiteral("key");
    QTest::newRow("no certificate") << file << none << file << QStringLiteral("key");
}

/// A node with a certificate of ours is spoken to with TLS or not at all. What was stored stays, so
/// that it can be completed.
void PacsSourceTest::halfOfTlsIsRefused()
{
    QFETCH(QString, authority);
    QFETCH(QString, certificate);
    QFETCH(QString, key);
    QFETCH(QString, missing);
    core::PacsSource source = archive();
    auto& node = std::get<core::PacsNode>(source.node);
    node.tls = {.authorityFile = authority, .certificateFile = certificate, .keyFile = key};
    const core::Result<void> sound = source.check();
    QCOMPARE(sound.has_value(), missing.isEmpty());
    if (!sound) {
        QCOMPARE(sound.error().code, core::ErrorCode::InvalidField);
        QCOMPARE(sound.error().arguments.value(0), missing);
        const auto asked = core::echoNode(source, core::Progress());
        QVERIFY(!asked);
        QCOMPARE(asked.error().code, core::ErrorCode::InvalidField);
    }
    const auto kept = core::sourcesFromJson(core::toJson({source}));
    QCOMPARE(kept.size(), std::size_t(1));
    QCOMPARE(std::get<core::PacsNode>(kept[0].node).tls.certificateFile, certificate);
    QCOMPARE(std::get<core::PacsNode>(kept[0].node).tls.keyFile, key);
}

BURIN_TEST(PacsSourceTest)

} // namespace pacsSourceTest

#include "PacsSourceTest.moc"
