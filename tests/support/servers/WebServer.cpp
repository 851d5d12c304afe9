// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/WebServer.h"

#include <QThread>

#include <algorithm>
#include <array>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

namespace {

bool say(int client, const QByteArray& bytes)
{
    for (qsizetype at = 0; at < bytes.size();) {
        const ssize_t sent =
            ::send(client, bytes.constData() + at, std::size_t(bytes.size() - at), MSG_NOSIGNAL);
        if (sent <= 0)
            return false;
        at += sent;
    }
    return true;
}

qsizetype lengthIn(const QByteArray& head)
{
    const qsizetype at = head.toLower().indexOf("content-length:");
    return at < 0 ? 0 : head.mid(at + 15, head.indexOf('\r', at) - at - 15).trimmed().toLongLong();
}

} // namespace

WebServer::WebServer(Answer answer)
    : m_answer(std::move(answer))
    , m_thread([this] { work(); })
{
}

WebServer::~WebServer()
{
    m_ending = true;
    m_thread.join();
}

QUrl WebServer::url() const
{
    return QUrl(QStringLiteral("http://127.0.0.1:%1/dicom-web").arg(m_listener.port()));
}

std::vector<QByteArray> WebServer::questions() const
{
    const std::lock_guard lock(m_mutex);
    return m_questions;
}

void WebServer::work()
{
    while (!m_ending) {
        const int client = m_listener.accepted();
        if (client < 0)
            continue;
        converse(client);
        ::close(client);
    }
}

void WebServer::converse(int client)
{
    QByteArray question;
    qsizetype wanted = -1;
    std::array<char, 65536> bytes{};
    while (!m_ending && (wanted < 0 || question.size() < wanted)) {
        pollfd waiting{client, POLLIN, 0};
        if (::poll(&waiting, 1, 20) < 1)
            continue;
        const ssize_t count = ::read(client, bytes.data(), bytes.size());
        if (count <= 0)
            return;
        question.append(bytes.data(), count);
        const qsizetype head = question.indexOf("\r\n\r\n");
        if (head >= 0)
            wanted = head + 4 + lengthIn(question.left(head + 2));
    }
    const QByteArray line = question.left(question.indexOf(" HTTP/"));
    {
        const std::lock_guard lock(m_mutex);
        m_questions.push_back(line);
    }
    const WebReply reply = m_answer(line, question);
    QByteArray head = "HTTP/1.1 " + QByteArray::number(reply.status)
        + " Said so\r\nConnection: close\r\nContent-Type: " + reply.contentType + "\r\n"
        + reply.moreHeaders;
    if (!reply.withoutLength)
        head += "Content-Length: " + QByteArray::number(reply.body.size()) + "\r\n";
    if (!say(client, head + "\r\n"))
        return;
    const qsizetype end = reply.afterBytes < 0
        ? reply.body.size()
        : std::min<qsizetype>(reply.body.size(), reply.afterBytes);
    const qsizetype step = reply.dripMs > 0 ? 1000 : std::max<qsizetype>(1, end);
    for (qsizetype at = 0; at < end && !m_ending; at += step) {
        if (!say(client, reply.body.mid(at, std::min(step, end - at))))
            return;
        if (reply.dripMs > 0)
            QThread::msleep(ulong(reply.dripMs));
    }
    while (!m_ending && reply.afterBytes >= 0 && reply.fault == WebReply::Fault::Stall) {
        // Until the client has had enough.
        pollfd waiting{client, POLLIN, 0};
        if (::poll(&waiting, 1, 20) > 0)
            return;
    }
}

} // namespace test
