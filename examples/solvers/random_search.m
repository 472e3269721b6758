% Random search in Octave: octave-cli --quiet --no-init-file examples/solvers/random_search.m
% Lines are read with input("", "s"). fgetl(stdin) would wait for more than one line, for ever.
1;

function say(message)
  fputs(stdout, [jsonencode(message) "\n"]);
  fflush(stdout);
end

function answer = ask(x)
  message.ask = num2cell(x(:)');  % a list, also of one number
  say(message);
  answer = jsondecode(input("", "s"));
end

say(struct("name", "octave-random-search", "stochastic", true));
while true
  try
    problem = jsondecode(input("", "s"));
  catch
    break;  % the end of the input
  end
  rand("twister", problem.seed);
  x = problem.start;
  answer = ask(x);
  while !isfield(answer, "stop")
    x = problem.lower + rand(size(x)) .* (problem.upper - problem.lower);
    answer = ask(x);
  end
  say(struct("done", "stopped"));
end
