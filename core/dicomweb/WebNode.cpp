// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebNode.h"

#include <QFile>
#include <QFileInfo>

namespace core {

namespace {

tl::unexpected<Error> wrongAddress(const Clause& why)
{
    return failure(ErrorCode::InvalidField, QStringLiteral("address"), why);
}

} // namespace

QByteArray WebLogin::header() const
{
    if (!token.isEmpty())
        return "Bearer " + token.toUtf8();
    if (!user.isEmpty())
        return "Basic " + (user + u':' + password).toUtf8().toBase64();
    return {};
}

Result<WebLogin> WebLogin::parse(const QString& text)
{
    const QString line = text.trimmed();
    const QString bearer = QStringLiteral("Bearer ");
    WebLogin login;
    const qsizetype colon = line.indexOf(u':');
    if (line.startsWith(bearer, Qt::CaseInsensitive)) {
        login.token = line.mid(bearer.size()).trimmed();
    } else if (colon > 0) {
        login.user = line.left(colon);
        login.password = line.mid(colon + 1);
    }
    // A line feed would begin another header.
    const bool isOneLine = !line.contains(u'\n') && !line.contains(u'\r');
    if (!login.isGiven() || !isOneLine) {
        return failure(ErrorCode::InvalidField, QStringLiteral("login"),
            Clause::saying("it is 'user:password' or 'Bearer TOKEN', in one line"));
    }
    return login;
}

Result<WebLogin> WebLogin::read(const QString& path)
{
    QFile file(path);
    if (!file.exists())
        return failure(ErrorCode::FileNotFound, path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    constexpr QFile::Permissions others =
        QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    if (QFileInfo(path).permissions() & others) {
        return failure(ErrorCode::FileUnreadable, path,
            Clause::saying("others may read the login in it; chmod 600 keeps it to you"));
    }
    constexpr qint64 longest = 64 << 10; // tokens of the web are a few kilobytes
    return parse(QString::fromUtf8(file.readLine(longest)));
}

bool WebNode::isAddress(const QString& text)
{
    return text.startsWith(QLatin1String("http://"), Qt::CaseInsensitive)
        || text.startsWith(QLatin1String("https://"), Qt::CaseInsensitive);
}

Result<WebNode> WebNode::parse(const QString& text)
{
    WebNode node;
    node.url = QUrl(text.trimmed(), QUrl::StrictMode);
    if (const Result<void> sound = node.check(); !sound)
        return tl::unexpected<Error>(sound.error());
    QString path = node.url.path();
    while (path.endsWith(u'/'))
        path.chop(1);
    node.url.setPath(path);
    return node;
}

Result<void> WebNode::check() const
{
    const QString scheme = url.scheme();
    if (!url.isValid() || url.host().isEmpty()
        || (scheme != QLatin1String("https") && scheme != QLatin1String("http")))
        return wrongAddress(Clause::saying("it is not of the form https://host/dicom-web"));
    if (!url.userInfo().isEmpty())
        return wrongAddress(
            Clause::saying("a password has no place in it; a file holds the login"));
    if (url.hasQuery() || url.hasFragment())
        return wrongAddress(Clause::saying("it ends before any ? or #"));
    if (timeoutSeconds < 1) {
        return failure(ErrorCode::InvalidField, QStringLiteral("timeout"),
            Clause::saying("it is 1 second or more"));
    }
    if (certificateFile.isEmpty() != keyFile.isEmpty()) {
        return failure(ErrorCode::InvalidField, QStringLiteral("key"),
            Clause::saying("certificate and key go together"));
    }
    return {};
}

} // namespace core
