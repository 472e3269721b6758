#include "src/experiment/store.h"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/archive.h"
#include "src/experiment/draft_store.h"
#include "src/experiment/merge.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/store_file.h"

namespace ricochet {

namespace fs = std::filesystem;

std::map<std::string, std::string> CampaignDescription::hashes() const {
  std::map<std::string, std::string> all;
  for (const StoredProblem& problem : problems) all[problem.name] = problem.hash;
  return all;
}

struct Store::Database {
  fs::path file;
  std::optional<ScratchFolder> unpacked;  // if the file is an archive
  std::unique_ptr<WriterLock> lock;       // null if the store is only read
  struct stat opened {};                  // what the file was then, if runs may be added
  std::unique_ptr<SQLite::Database> connection;
  CampaignDescription description;
  std::unique_ptr<RunRows> rows;
  std::optional<AtInterruption> interrupted;

  ~Database() { finish(); }

  void finish() {
    const Uninterrupted whole;
    if (!lock) return;
    if (connection) close_database(*connection);
    lock.reset();
  }

  /// Everything that `work` reads is from one moment: that of the enclosing read, if there is one.
  /// A store that is open for adding cannot be closed meanwhile.
  template <class Work>
  auto reading(const Work& work) const {
    std::optional<Uninterrupted> whole(std::in_place);
    if (!lock) whole.reset();
    try {
      std::optional<SQLite::Transaction> moment;
      if (sqlite3_get_autocommit(connection->getHandle()) != 0) moment.emplace(*connection);
      return work();
    } catch (const SQLite::Exception& error) {
      throw InputError(fmt::format("{}: cannot be read: {}", file.string(), error.what()));
    } catch (const Damage& error) {
      throw InputError(fmt::format("{}: is damaged: {}", file.string(), error.what()));
    }
  }
};

Store::Store(std::unique_ptr<Database> database) : database_(std::move(database)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::create(const fs::path& file, const CampaignDescription& description) {
  DraftStore(file, description).place();
  return open(file, For::adding);
}

namespace {

void write_at(const fs::path& file, DraftStore::Place where, const CampaignDescription& description,
              const std::function<void(const Store::AddRun&)>& fill) {
  DraftStore draft(file, description, where);
  try {
    SQLite::Transaction all(draft.database());
    RunRows rows(draft.database());
    fill([&](const RunKey& key, const RunRecord& record) { rows.add(key, record); });
    all.commit();
  } catch (const SQLite::Exception& error) {
    throw OutputError(fmt::format("{}: cannot be written: {}", file.string(), error.what()));
  }
  draft.place();
}

}  // namespace

void Store::write(const fs::path& file, const CampaignDescription& description,
                  const std::function<void(const AddRun&)>& fill) {
  write_at(file, DraftStore::Place::must_be_free, description, fill);
}

void Store::replace(const fs::path& file, const CampaignDescription& description,
                    const std::function<void(const AddRun&)>& fill) {
  write_at(fs::canonical(file), DraftStore::Place::is_replaced, description, fill);
}

void Store::pack(const fs::path& file) {
  SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("VACUUM");
}

Store Store::open(const fs::path& file, For purpose) {
  auto database = std::make_unique<Database>();
  database->file = file;
  if (purpose == For::reading && is_archive(file)) {
    const fs::path store = database->unpacked.emplace().path() / "runs.sqlite";
    unpack_archive(file, store);
    database->connection = opened_for_reading(store, file);
  } else if (purpose == For::reading) {
    database->connection = opened_for_reading(file);
  } else {
    check_is_store(file);
    database->interrupted.emplace([held = database.get()] { held->finish(); });
    {
      const Uninterrupted made_and_known;
      database->lock = std::make_unique<WriterLock>(file);
    }
    check_store(file);
    const Uninterrupted made_and_known;
    database->connection = opened_for_adding(file);
    ::stat(file.c_str(), &database->opened);
  }
  database->reading([&] {
    database->description = description_in(*database->connection);
    database->rows = std::make_unique<RunRows>(*database->connection);
  });
  return Store(std::move(database));
}

const CampaignDescription& Store::description() const {
  return database_->description;
}

void Store::add(const RunKey& key, const RunRecord& record) {
  const Uninterrupted whole;
  struct stat now {};
  const struct stat& then = database_->opened;
  if (::stat(database_->file.c_str(), &now) != 0 || now.st_ino != then.st_ino ||
      now.st_dev != then.st_dev) {
    throw OutputError(
        fmt::format("{}: was removed while runs were added to it", database_->file.string()));
  }
  RunRows& rows = *database_->rows;
  try {
    SQLite::Transaction transaction(*database_->connection, SQLite::TransactionBehavior::IMMEDIATE);
    rows.add(key, record);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    rows.forget();
    const std::string file = database_->file.string();
    if (error.getExtendedErrorCode() == SQLITE_CONSTRAINT_UNIQUE) {
      throw InputError(fmt::format("{}: {} is there already", file, name_of(key)));
    }
    throw OutputError(fmt::format("{}: cannot be written: {}", file, error.what()));
  } catch (...) {
    rows.forget();
    throw;
  }
}

void Store::finish() {
  database_->finish();
}

std::set<RunKey> Store::keys() const {
  return database_->reading([this] { return database_->rows->keys(); });
}

std::int64_t Store::size() const {
  return database_->reading([this] { return database_->rows->size(); });
}

void Store::each(const std::function<void(const StoredRun&)>& use) const {
  database_->reading([&] { database_->rows->each(use); });
}

std::optional<StoredRun> Store::find(std::int64_t number) const {
  return database_->reading([&] { return database_->rows->find(number); });
}

std::optional<StoredRun> Store::find(const RunKey& key) const {
  return database_->reading([&] { return database_->rows->find(key); });
}

std::string Store::digest() const {
  Digest digest(description());
  each([&digest](const StoredRun& run) { digest.add(run.key, run.record); });
  return digest.text();
}

namespace {

/// Reads a whole number >= 0; false if the text is anything else.
template <class Number>
bool read_count(std::string_view text, Number& count) {
  const auto number = number_of_text<Number>(text);
  if (number && *number >= 0) count = *number;
  return number && *number >= 0;
}

}  // namespace

std::string name_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format(
      "run {} of {} on instance {} of {} (formulation {}, perturbation {}, budget {}, gradient "
      "price {})",
      key.run, cell.solver, key.instance, cell.problem, cell.formulation, cell.perturbation,
      cell.budget, cell.gradient_price);
}

std::string address_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format("{}/{}/{}/{}/{}/{}/{}/{}", cell.problem, cell.formulation, cell.perturbation,
                     cell.solver, cell.budget, cell.gradient_price, key.instance, key.run);
}

std::optional<RunKey> key_at(const std::string& address) {
  std::vector<std::string> parts(1);
  for (const char c : address) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  constexpr std::size_t members = 8;
  RunKey key;
  if (parts.size() != members || !read_count(parts[4], key.cell.budget) ||
      !read_count(parts[6], key.instance) || !read_count(parts[7], key.run)) {
    return std::nullopt;
  }
  key.cell.problem = parts[0];
  key.cell.formulation = parts[1];
  key.cell.perturbation = parts[2];
  key.cell.solver = parts[3];
  key.cell.gradient_price = parts[5];
  return key;
}

}  // namespace ricochet
