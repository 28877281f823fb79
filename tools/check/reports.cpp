#include "reports.h"

#include <utility>

#include "traj/record/certificate_record.h"
#include "traj/record/verdict.h"

namespace checking {

Reports::Reports(const ReportFiles& files, const cli::Sharding& sharding, const geom::BoxMap& map)
    : files_(files), map_(map), beyond_(map), out_(files.report.file(), "output", sharding) {
  if (!files.certificate.empty()) certificates_.emplace(files.certificate, "certificate", sharding);
  files_.profile.open(sharding);
  if (!files.junit.empty()) junit_.emplace(files.junit, cli::OutputKind::text);
  if (files.report.is_text()) table_.emplace();
}

Told Reports::told(Checks checks) const {
  Told out;
  traj::ReportRecord& report = checks.report;
  out.ok = traj::accepted(report);
  report.dropped = !out.ok && files_.drop_refused;
  if (!out.ok) out.sentence = report.id + ": " + in_words(report, map_);
  if (!table_) out.line = traj::to_json_line(report, map_);
  if (certificates_ && out.ok) out.certificate = certificate(report);
  out.checks = std::move(checks);
  return out;
}

void Reports::add(Told told) {
  const traj::ReportRecord& report = told.checks.report;
  if (report.dropped) dropped_.push_back(report.id);
  failed_ += !told.ok;
  ++count_;
  told.ok ? batch_.add_good() : batch_.add_failed(verdict_word(report), std::move(told.sentence));
  if (!told.ok && report.result.reason == traj::Reason::bounds) {
    beyond_.add(report.provenance, report.result.place, report.result.worst);
  }
  if (certificates_) certificates_->add(told.certificate);
  files_.profile.add(told.checks.profile);
  if (junit_) suite_.add(report, map_);
  if (table_) return table_->add(report, map_);
  out_.add(told.line);
  out_.flush();
}

void Reports::add(const Together& together, const traj::TogetherResult& result) {
  refused_ += !result.ok() || together.left_out() > 0;
  if (junit_) suite_.add(result, together.task(), together.left_out());
  if (table_) {
    table_->add(result, together.task(), together.left_out());
  } else {
    for (const traj::RefusedPair& pair : result.refused) {
      out_.add(traj::to_json_line(pair, together.task()));
    }
    out_.add(traj::to_json_line(result, together.task(), together.left_out()));
  }
  if (!certificates_) return;
  for (const traj::ProvedPair& pair : result.proved) {
    certificates_->add(traj::certificate_line(pair, together.task()));
  }
  if (result.ok() && together.left_out() == 0) {
    certificates_->add(traj::certificate_line(together.task(), together.flights()));
  }
}

void Reports::add(const traj::MovingObstacles::Found& found) {
  refused_ += !found.summary.ok();
  if (junit_) suite_.add(found.conflicts, found.summary);
  if (table_) {
    table_->add(found.conflicts, found.summary);
  } else {
    for (const traj::MovingConflict& one : found.conflicts) {
      out_.add(traj::to_json_line(one, found.summary.epoch));
    }
    out_.add(traj::to_json_line(found.summary));
  }
  if (!certificates_) return;
  for (const traj::ProvedMoving& one : found.proved) {
    certificates_->add(traj::certificate_line(one));
  }
  if (found.summary.ok()) certificates_->add(traj::certificate_line(found.claim));
}

cli::Exit Reports::commit(std::size_t total) {
  const bool ok = files_.drop_refused ? refused_ == 0 && count_ > failed_ : refused_ + failed_ == 0;
  const cli::Exit exit = ok ? cli::Exit::yes : cli::Exit::no;
  if (table_) out_.add(table_->text(files_.report.colour()));
  out_.commit(total, exit);
  if (certificates_) certificates_->commit(total, exit);
  files_.profile.commit(total, exit);
  if (junit_) {
    junit_->stream() << suite_.xml();
    junit_->commit();
  }
  return exit;
}

std::string Reports::certificate(const traj::ReportRecord& report) const {
  std::string lines;
  if (report.exact) lines += way_certificate(report);
  if (report.returns) lines += traj::return_certificate_line(report, map_);
  return lines;
}

std::string Reports::way_certificate(const traj::ReportRecord& report) const {
  traj::CertificateRecord record{report.id,          report.checked,    *report.exact,
                                 map_.spec().bounds, report.provenance, report.limits,
                                 report.overridden};
  if (report.by_time) {
    record.epoch = map_.spec().epoch;
    record.start = report.time.start;
    record.stands = files_.parks;
  }
  return to_json_line(record);
}

}  // namespace checking
