-module(eqc_gen_tests).

-include_lib("eunit/include/eunit.hrl").

generators_are_propers_test() ->
    Values = [{eqc_gen:int(), fun is_integer/1}, {eqc_gen:nat(), fun(N) -> N >= 0 end},
              {eqc_gen:bool(), fun is_boolean/1}, {eqc_gen:real(), fun is_float/1},
              {eqc_gen:choose(3, 4), fun(N) -> N =:= 3 orelse N =:= 4 end},
              {eqc_gen:elements([a]), fun(X) -> X =:= a end},
              {eqc_gen:oneof([b]), fun(X) -> X =:= b end},
              {eqc_gen:frequency([{1, c}]), fun(X) -> X =:= c end},
              {eqc_gen:list(d), fun is_list/1},
              {eqc_gen:vector(2, e), fun(X) -> X =:= [e, e] end},
              {eqc_gen:binary(), fun is_binary/1},
              {eqc_gen:binary(3), fun(B) -> byte_size(B) =:= 3 end},
              {eqc_gen:return(f), fun(X) -> X =:= f end}],
    [begin
         {ok, Value} = proper_gen:pick(Type),
         ?assert(Is(Value))
     end || {Type, Is} <- Values].
