#include "ipopt_solve.h"

#include <IpIpoptApplication.hpp>
#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <mutex>
#include <new>
#include <span>
#include <stdexcept>

#include "geom/base/loaded_library.h"

namespace traj {
namespace {

using Ipopt::Index;
using Ipopt::Number;

class Adapter : public Ipopt::TNLP {
 public:
  Adapter(const Nlp& nlp, IpoptOutcome& outcome) : nlp_(nlp), outcome_(outcome) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian,
                    IndexStyleEnum& style) override {
    n = nlp_.variables();
    m = nlp_.constraints();
    jacobian = static_cast<Index>(nlp_.jacobian_entries().size());
    hessian = static_cast<Index>(nlp_.hessian_entries().size());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* x_lower, Number* x_upper, Index m, Number* g_lower,
                       Number* g_upper) override {
    std::copy(nlp_.lower().begin(), nlp_.lower().end(), x_lower);
    std::copy(nlp_.upper().begin(), nlp_.upper().end(), x_upper);
    std::fill(g_lower, g_lower + m, -1e20);
    std::copy(nlp_.bound().begin(), nlp_.bound().end(), g_upper);
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy(nlp_.start().begin(), nlp_.start().end(), x);
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    return kept([&] {
      value = nlp_.objective(all(x, n));
      return std::isfinite(value);
    });
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* out) override {
    return kept([&] { return copied(nlp_.gradient(all(x, n)), out); });
  }

  bool eval_g(Index n, const Number* x, bool, Index, Number* out) override {
    return kept([&] { return copied(nlp_.constraint_values(all(x, n)), out); });
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index, Index, Index* row, Index* column,
                  Number* out) override {
    if (!out) return entries(nlp_.jacobian_entries(), row, column);
    return kept([&] { return copied(nlp_.jacobian(all(x, n)), out); });
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* multipliers,
              bool, Index, Index* row, Index* column, Number* out) override {
    if (!out) return entries(nlp_.hessian_entries(), row, column);
    return kept([&] { return copied(nlp_.hessian(all(x, n), factor, all(multipliers, m)), out); });
  }

  // The last digits of the optimum cost most of the iterations and are not worth them: stops when
  // the barrier is low, the point feasible, and the objective has settled.
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Index iteration, Number objective,
                             Number infeasibility, Number, Number mu, Number, Number, Number,
                             Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return kept([&] { return goes_on(mode, iteration, objective, infeasibility, mu); });
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    kept([&] {
      outcome_.x.assign(x, x + n);
      return true;
    });
  }

  // Once Ipopt has returned: what went wrong in any of these.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  // Ipopt takes an exception for a failed evaluation, and looks elsewhere: it is kept, and the
  // solve ends (intermediate_callback() comes once an iteration).
  template <class F>
  bool kept(const F& f) noexcept {
    if (failure_) return false;
    try {
      return f();
    } catch (...) {
      failure_ = std::current_exception();
      return false;
    }
  }

  bool goes_on(Ipopt::AlgorithmMode mode, Index iteration, Number objective, Number infeasibility,
               Number mu) {
    outcome_.iterations = iteration;
    if (mode != Ipopt::RegularMode) recent_.clear();
    recent_.push_back(objective);
    if (recent_.size() > 7) recent_.pop_front();
    if (recent_.size() < 7 || mu > 2e-3 || infeasibility > 1e-4) return true;
    const auto [least, most] = std::minmax_element(recent_.begin(), recent_.end());
    return *most - *least >= 1e-3 * std::max(1.0, std::abs(objective));
  }

  static std::span<const double> all(const Number* x, Index n) {
    return {x, static_cast<std::size_t>(n)};
  }
  static bool copied(const std::vector<double>& values, Number* out) {
    std::copy(values.begin(), values.end(), out);
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  }
  static bool entries(const std::vector<Nlp::Entry>& from, Index* row, Index* column) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      row[i] = from[i].row;
      column[i] = from[i].column;
    }
    return true;
  }

  const Nlp& nlp_;
  IpoptOutcome& outcome_;
  std::deque<double> recent_;
  std::exception_ptr failure_;
};

std::string words(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "solved";
    case Ipopt::Solved_To_Acceptable_Level:
      return "acceptable";
    case Ipopt::User_Requested_Stop:
      return "settled";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "iteration limit";
    case Ipopt::Infeasible_Problem_Detected:
      return "locally infeasible";
    case Ipopt::Restoration_Failed:
      return "restoration failed";
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return "step too small";
    case Ipopt::Diverging_Iterates:
      return "diverging";
    default:
      return "error " + std::to_string(static_cast<int>(status));
  }
}

void set_options(Ipopt::IpoptApplication& app, int max_iterations) {
  const auto& options = app.Options();
  options->SetStringValue("sb", "yes");
  options->SetIntegerValue("print_level", 0);
  // The only one in Debian's build; any other name ends the process.
  options->SetStringValue("linear_solver", "mumps");
  options->SetIntegerValue("mumps_pivot_order", 0);
  options->SetStringValue("mu_strategy", "monotone");
  options->SetNumericValue("mu_init", 0.1);
  options->SetNumericValue("mu_linear_decrease_factor", 0.2);
  // Loose barrier steps: short durations make the dual error large long after the point has
  // settled, and a hundredth of this keeps staircase paths at a high barrier to the last iteration.
  options->SetNumericValue("barrier_tol_factor", 1e4);
  options->SetNumericValue("tol", 1e-4);
  options->SetNumericValue("constr_viol_tol", 1e-7);
  options->SetNumericValue("acceptable_tol", 1e-3);
  options->SetNumericValue("bound_relax_factor", 0);
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetIntegerValue("max_iter", max_iterations);
}

// Ipopt and what it needs take longer to load than the rest of a tool's start, and few paths need
// it. All else of Ipopt is reached through virtual functions.
Ipopt::SmartPtr<Ipopt::IpoptApplication> new_application() {
  static const geom::LoadedLibrary library(SKYWAY_IPOPT_SONAME, "coinor-libipopt1v5");
  decltype(IpoptApplicationFactory)* const make = library.function("IpoptApplicationFactory");
  return make();
}

}  // namespace

IpoptOutcome ipopt_solve(const Nlp& nlp, int max_iterations) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  IpoptOutcome outcome;
  outcome.x = nlp.start();
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new_application();
  set_options(*app, max_iterations);
  // An empty name: otherwise a file ipopt.opt in the working directory would be obeyed.
  if (app->Initialize(std::string()) != Ipopt::Solve_Succeeded) {
    throw std::runtime_error("Ipopt could not be initialised");
  }
  const Ipopt::SmartPtr<Adapter> adapter = new Adapter(nlp, outcome);
  const Ipopt::ApplicationReturnStatus status =
      app->OptimizeTNLP(Ipopt::SmartPtr<Ipopt::TNLP>(Ipopt::GetRawPtr(adapter)));
  adapter->rethrow();
  // No answer: with more memory there would be another.
  if (status == Ipopt::Insufficient_Memory) throw std::bad_alloc();
  outcome.status = words(status);
  outcome.settled = status == Ipopt::Solve_Succeeded ||
                    status == Ipopt::Solved_To_Acceptable_Level ||
                    status == Ipopt::User_Requested_Stop;
  return outcome;
}

}  // namespace traj
