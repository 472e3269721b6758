// Scilab's ode("root", ...), which is LSODAR of ODEPACK. As its manual says, %ODEOPTIONS bounds the
// step and keeps it from passing the next jump of the force.
function [impacts, last] = simulate(m, level)
    tolerance = [1e-4, 1e-6, 1e-10](level); rest = m.slowest / 4;
    m.k = 1; m.y = [m.position; m.velocity]; t = 0; impacts = [];
    walls = [m.lower, m.upper]; bounce = -[m.restitution_lower, m.restitution_upper];
    scale = [m.scales.length; m.scales.speed];
    m = settle(m, t, %f);
    for event = 1:20000
        if t >= m.duration then last = m.y; return; end
        stop = min([m.from(m.k + 1:$); m.duration]);
        longest = min([m.scales.step; ones(m.moves, 1) * scale(1) / scale(2)]);
        %ODEOPTIONS = [4, stop, 0, longest, 0, 2, 1e6, 12, 5, 0, -1, -1];
        // LSODAR refuses a function that stays zero at the start: hence a little off it.
        off = 1e-9 * m.moves * scale .* [bool2s(m.y(1) <= m.lower) - ..
            bool2s(m.y(1) >= m.upper); m.way * bool2s(m.y(2) == 0)];
        [y, found] = ode("root", m.y + off, t, stop, tolerance, ..
                         tolerance * scale, list(rates, m), 3, list(values, m));
        moved = m.moves; m.y = y(:, $); t = stop;
        if found <> [] then t = found(1); end
        if stop - t < 1e-12 & stop < m.duration then m.k = m.k + 1; end
        if found <> [] & moved & found(2) == 3 then
            m.y(2) = 0;
        elseif found <> [] & moved then
            w = found(2); approach = m.y(2) * (2 * w - 3); m.y(1) = walls(w);
            if approach > 0 then impacts($ + 1, 1:3) = [t, w, approach]; end
            if approach > 0 then m.y(2) = m.y(2) * bounce(w); end
            if (approach <= 0 | abs(m.y(2)) < rest) & hold(m, t) >= 0 then m.y(2) = 0; end
        end
        if found <> [] | ~moved then m = settle(m, t, found <> [] & ~moved); end
    end
    error("too many events");
endfunction

warning("off");
exec(get_absolute_file_path("scilab.sce") + "tool.sci", -1);
tool();
exit
